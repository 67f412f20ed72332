// Sums of light, not multiplied by a surface's colours: three texels hold the first four sums, the fourth in their
// alphas; a fourth texel holds `area`, if there are area lights. c: light colour, N·L: cosine, V and D: terms of the
// lobe.
// Engel 2009, The Light Pre-Pass Renderer (ShaderX7 8.5); three.js r187's RE_Direct, split by Fresnel's weight
#include "areaLight"
struct FarolLightSums {
  // physical: sum of c N·L (1 - f), f: Schlick's fifth power; else sum of c N·L and of the lights' ambient
  vec3 diffuse;
  // physical: ambient parts of lights and diffuse light of area lights, plus sum of c N·L f where F90 is below 1
  vec3 rest;
  vec3 specularF0; // sum of c N·L V D (1 - f)
  vec3 specularF90; // sum of c N·L V D f
#ifdef FAROL_AREA_LIGHTS
  vec3 area; // sum of c times the specular lobe's integral over an area light
#endif
};

FarolLightSums farol_noSums() {
  FarolLightSums sums;
  sums.diffuse = sums.rest = sums.specularF0 = sums.specularF90 = vec3(0.0);
#ifdef FAROL_AREA_LIGHTS
  sums.area = vec3(0.0);
#endif
  return sums;
}
