"""PNG files (W3C PNG, third edition) without compression, since compressors differ between machines."""
import struct
import zlib

GREY, RGB, PALETTE = 0, 2, 3


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def stored(data):
    """A zlib stream of stored blocks (RFC 1950, RFC 1951 section 3.2.4)."""
    blocks = [data[i:i + 65535] for i in range(0, len(data), 65535)] or [b""]
    body = b"".join(struct.pack("<BHH", i == len(blocks) - 1, len(block), len(block) ^ 0xFFFF) + block
                    for i, block in enumerate(blocks))
    return b"\x78\x01" + body + struct.pack(">I", zlib.adler32(data))


def encoded(width, height, bits, color_type, rows, palette=None):
    header = struct.pack(">IIBBBBB", width, height, bits, color_type, 0, 0, 0)
    chunks = [chunk(b"IHDR", header)]
    if palette:
        chunks.append(chunk(b"PLTE", b"".join(bytes(color) for color in palette)))
    chunks.append(chunk(b"IDAT", stored(b"".join(b"\0" + row for row in rows))))
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunks) + chunk(b"IEND", b"")


def rgb(rows):
    """Rows of (r, g, b), each 0 to 255."""
    return encoded(len(rows[0]), len(rows), 8, RGB, [b"".join(bytes(pixel) for pixel in row) for row in rows])


def indexed(rows, palette):
    """Rows of indices into at most 16 colours, two pixels a byte. The width is even."""
    packed = [bytes(row[i] << 4 | row[i + 1] for i in range(0, len(row), 2)) for row in rows]
    return encoded(len(rows[0]), len(rows), 4, PALETTE, packed, palette)
