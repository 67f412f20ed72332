// Flags of a surface: its shading model, fog, shadows and the like.
// Farol; made from the tables of gbuffer/surfaceFlags.ts by gbuffer/gbufferChunks.test.ts
//? farol_unpackFlags(farol_packFlags(13)) == 13
//? farol_hasFog(13) == true
//? farol_receivesShadows(13) == false
const int FAROL_UNLIT = 0;
const int FAROL_STANDARD = 1;
const int FAROL_PHONG = 2;
const int FAROL_LAMBERT = 3;
const int FAROL_RECEIVES_SHADOWS = 16;
const int FAROL_HAS_VERTEX_NORMAL = 64;
const int FAROL_IS_REVERSED = 128;
int farol_shadingModel(const in int flags) { return flags & 3; }
float farol_packFlags(const in int flags) { return float(flags) / 255.0; }
int farol_unpackFlags(const in float stored) { return int(stored * 255.0 + 0.5); }
bool farol_receivesShadows(const in int flags) { return (flags & 16) != 0; }
bool farol_hasFog(const in int flags) { return (flags & 4) != 0; }
bool farol_isToneMapped(const in int flags) { return (flags & 8) != 0; }
bool farol_isDithered(const in int flags) { return (flags & 32) != 0; }
bool farol_hasVertexNormal(const in int flags) { return (flags & 64) != 0; }
bool farol_isReversed(const in int flags) { return (flags & 128) != 0; }
