// Features of the scene and the material. The renderer overlays this file with their values
// (src/render/gpu/features.cpp), and the compiler drops the rest. The defaults here cover a plain
// material with every texture.
// The kinds of lights, by their numbers in interface/lights.glsl, and which of them there are.
const int point_light = 0;
const int spot_light = 1;
const int directional_light = 2;
const int rectangle_light = 3;
const int disk_light = 4;
const int sphere_light = 5;
const int tube_light = 6;
const int polygon_light = 7;
const int mesh_light = 8;
const int environment_light = 9;
const int light_kinds = 10;
const bool has_point_lights = true;
const bool has_spot_lights = true;
const bool has_directional_lights = true;
const bool has_rectangle_lights = true;
const bool has_disk_lights = true;
const bool has_sphere_lights = true;
const bool has_tube_lights = true;
const bool has_polygon_lights = true;
const bool has_mesh_lights = true;
const bool has_environment_lights = true;
const bool has_sun_disks = true;        // directional lights with an angular radius
const bool has_profiles = true;         // photometric profiles
const bool has_emission_maps = true;    // textured emitters
const bool has_environment_maps = true; // environments that are pictures

const bool has_base_color_texture = true;
const bool has_metallic_roughness_texture = true;
const bool has_normal_texture = true;
const bool has_emission_texture = true;
const bool has_specular_texture = true;
const bool has_specular_color_texture = true;
const bool has_packed_metallic_roughness = false; // metalness in the alpha of the normal map, roughness in the base colour's
const bool has_second_uv = true; // a texture reads the second set of coordinates
const bool has_vertex_colors = true;

// Layers and forms that few materials have (KHR_materials_*, extras.steradian), and --energy-compensation.
const bool has_anisotropy = false;
const bool has_clearcoat = false;
const bool has_sheen = false;
const bool has_iridescence = false;
const bool has_energy_compensation = false;
const bool is_specular_glossiness = false;
const bool has_anisotropy_texture = true;
const bool has_clearcoat_texture = true;
const bool has_clearcoat_roughness_texture = true;
const bool has_clearcoat_normal_texture = true;
const bool has_sheen_color_texture = true;
const bool has_sheen_roughness_texture = true;
const bool has_iridescence_texture = true;
const bool has_film_thickness_texture = true;

// KHR_materials_transmission, _volume, _diffuse_transmission.
const bool is_transmissive = false;
const bool is_opaque_part = false; // of glass, only what its textures keep opaque is drawn
const bool has_diffuse_transmission = false;
const bool has_transmission_texture = true;
const bool has_thickness_texture = true;
const bool has_diffuse_transmission_texture = true;
const bool has_diffuse_transmission_color_texture = true;

const int rays_per_light = 2; // that a point sends to each light
const bool has_transparent_casters = true; // surfaces that are masked, blended or of glass cast shadows
const bool has_tinted_casters = true;      // glass does

const bool is_masked = true;  // alphaMode MASK
const bool is_blended = true; // alphaMode BLEND
const bool is_mirror = false;  // brdf/models/mirror.glsl
const bool is_lambert = false; // brdf/models/lambert.glsl
const bool is_unlit = false;  // KHR_materials_unlit; lines and points without normals
const bool is_line = false;   // the mesh is lines
const bool is_point = false;  // the mesh is points
