# What every exported folder gets.
set(plugin_names README.md render.py)
foreach(module __init__ framed measured metallic_roughness metals microfacets oren_nayar parameters phong punctual reflector
        sheen thin_film)
  list(APPEND plugin_names steradian_mitsuba/${module}.py)
endforeach()
