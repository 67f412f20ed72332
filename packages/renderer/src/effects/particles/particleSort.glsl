// Up to three steps of a bitonic network in one pass, farthest first. All comparators have one direction: sorted
// input stays sorted, and a part of the network never worsens an order.
// Batcher 1968, Sorting Networks and Their Applications; Kipfer and Westermann 2005, GPU Gems 2, chapter 46
uniform highp sampler2D farol_sorted; // order after the last pass: distance along the view (m), slot
uniform highp ivec3 farol_partners; // for each step: XOR of the indices of two partners; 0: no such step
layout(location = 0) out highp vec2 farol_key;
//# main
ivec2 texel = ivec2(gl_FragCoord.xy);
int columns = textureSize(farol_sorted, 0).x;
int index = texel.y * columns + texel.x;
vec2 keys[8];
int places[8];
for (int i = 0; i < 8; i++) {
  int place = index;
  if ((i & 1) != 0) place ^= farol_partners.x;
  if ((i & 2) != 0) place ^= farol_partners.y;
  if ((i & 4) != 0) place ^= farol_partners.z;
  places[i] = place;
  keys[i] = texelFetch(farol_sorted, ivec2(place % columns, place / columns), 0).xy;
}
for (int j = 0; j < 3; j++) {
  int bit = 1 << j;
  if ((j == 0 ? farol_partners.x : j == 1 ? farol_partners.y : farol_partners.z) == 0) continue;
  for (int i = 0; i < 8; i++) {
    if ((i & bit) != 0) continue;
    vec2 a = keys[i], b = keys[i | bit];
    bool swaps = places[i] < places[i | bit] ? a.x < b.x : b.x < a.x;
    keys[i] = swaps ? b : a;
    keys[i | bit] = swaps ? a : b;
  }
}
farol_key = keys[0];
