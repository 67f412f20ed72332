// Sums of light without a surface's colours; three texels hold all four: the last sum lies in the alphas.
// Engel 2009, The Light Pre-Pass Renderer (ShaderX7 8.5); three.js r187's RE_Direct, apart by Fresnel's weight
struct FarolLightSums {
  // physical: sum of c N·L (1 - f), f: Schlick's fifth power; else sum of c N·L and of the lights' ambient
  vec3 diffuse;
  vec3 rest; // physical: the lights' ambient, or sum of c N·L f where F90 is below 1
  vec3 specularF0; // sum of c N·L V D (1 - f)
  vec3 specularF90; // sum of c N·L V D f
};
