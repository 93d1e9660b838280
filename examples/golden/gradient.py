"""Stands for any renderer: writes a small Radiance .hdr file.  usage: gradient.py OUT.hdr"""
import sys

WIDTH, HEIGHT = 32, 16

with open(sys.argv[1], "wb") as file:
    file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + f"-Y {HEIGHT} +X {WIDTH}\n".encode())
    for y in range(HEIGHT):
        for x in range(WIDTH):
            file.write(bytes((128 + 3 * x, 128 + 7 * y, 200, 128)))  # mantissas of R, G and B, and the exponent 2^0
