// Light of a table's light at a point, as in three and Farol, with soft shadow edges
// three.js, lights_pars_begin; Lagarde and de Rousiers 2014, Moving Frostbite to PBR, equation 26
uniform highp sampler2D farol_lights; // table of lights, nine texels each, see lightTable.ts
uniform highp sampler2D farol_cells; // one texel per grid cell: index of the cell's first light, count
uniform highp sampler2D farol_cellLights; // indices of the cells' lights, four per texel
uniform ivec3 farol_grid; // number of cells along each axis
uniform vec3 farol_gridLeast;
uniform vec3 farol_gridScale; // number of cells per metre along each axis
uniform int farol_endlessLights; // number of lights without a range: they come first in the table, and are in no cell

float farol_falloff(const in float distance, const in float range, const in float decay) {
  float falloff = 1.0 / max(pow(distance, decay), 0.01);
  if (range > 0.0) {
    float ratio = distance / range;
    ratio *= ratio;
    float window = clamp(1.0 - ratio * ratio, 0.0, 1.0);
    falloff *= window * window;
  }
  return falloff;
}

// unshadowed light of a light at a point with a normal, and its direction
struct FarolArrival {
  vec3 irradiance;
  vec3 always; // light that shadows do not reduce
  vec3 path; // vector from the point to a (random) point on the light (m)
  bool isEndless;
};

FarolArrival farol_areaArrival(const in int light, const in int kind, const in vec3 center, const in vec3 colour,
  const in vec3 axis, const in vec3 position, const in vec3 normal, const in vec2 u) {
  FarolArrival arrival = FarolArrival(vec3(0.0), vec3(0.0), vec3(0.0), false);
  vec4 width = farol_table(farol_lights, 9 * light + 6); // xyz: vector along half the width (m); w: area
  vec4 height = farol_table(farol_lights, 9 * light + 7);
  vec2 part = kind == 4 ? farol_disc(u) : 2.0 * u - 1.0;
  vec3 shining = axis;
  vec3 toLight = center + part.x * width.xyz - position;
  if (kind == 5) {
    float radius = length(height.xyz);
    float angle = 3.14159265 * part.y;
    shining = cos(angle) * height.xyz / max(radius, 1e-9) + sin(angle) * axis;
    toLight += radius * shining;
  } else toLight += part.y * height.xyz;
  float squared = dot(toLight, toLight);
  vec3 along = toLight * inversesqrt(squared);
  float facing = max(dot(normal, along), 0.0) * max(-dot(shining, along), 0.0);
  arrival.irradiance = colour * facing * width.w / max(squared, 1e-8);
  arrival.path = toLight;
  return arrival;
}

FarolArrival farol_arrival(const in int light, const in vec3 position, const in vec3 normal, const in vec2 u) {
  FarolArrival arrival = FarolArrival(vec3(0.0), vec3(0.0), vec3(0.0), false);
  vec4 place = farol_table(farol_lights, 9 * light); // xyz: position (m); w: kind of the light
  vec4 colour = farol_table(farol_lights, 9 * light + 1); // rgb: linear colour × intensity; a: range (m)
  vec4 axis = farol_table(farol_lights, 9 * light + 2); // xyz: direction; w: decay
  vec4 cone = farol_table(farol_lights, 9 * light + 3); // cosines of cutoff, penumbra; radius (m); exponent or -1
  int kind = int(place.w);
  if (kind >= 3) return farol_areaArrival(light, kind, place.xyz, colour.rgb, axis.xyz, position, normal, u);
  if (kind == 0) {
    arrival.irradiance = max(dot(normal, axis.xyz), 0.0) * colour.rgb;
    arrival.path = axis.xyz;
    if (cone.z > 0.0) arrival.path = normalize(farol_basis(axis.xyz) * vec3(cone.z * farol_disc(u), 1.0));
    arrival.isEndless = true;
    return arrival;
  }
  vec3 toLight = place.xyz - position;
  float distance = length(toLight);
  if (colour.w > 0.0 && distance >= colour.w) return arrival;
  vec3 along = toLight / distance;
  vec4 law = farol_table(farol_lights, 9 * light + 4); // x: kind of falloff; yzw: its parameters
  float attenuation = 1.0;
  if (kind == 2) {
    float cosine = dot(along, axis.xyz);
    attenuation = cone.w >= 0.0 ? (cosine > cone.x ? pow(max(cosine, 0.0), cone.w) : 0.0)
      : smoothstep(cone.x, cone.y, cosine);
  }
  if (law.x == 1.0) attenuation *= clamp((law.z - distance) / max(law.z - law.y, 1e-6), 0.0, 1.0);
  else if (law.x == 2.0) attenuation /= max(law.y + distance * (law.z + distance * law.w), 0.01);
  else attenuation *= farol_falloff(distance, colour.w, axis.w);
  arrival.irradiance = attenuation * max(dot(normal, along), 0.0) * colour.rgb;
  // the light's `userData.farol.ambient`, which shadows do not reduce
  arrival.always = attenuation * farol_table(farol_lights, 9 * light + 5).rgb;
  arrival.path = toLight;
  if (cone.z > 0.0) arrival.path += cone.z * (farol_basis(along) * vec3(farol_disc(u), 0.0));
  return arrival;
}

// origin: start of the ray, offset from the surface at position
vec3 farol_unshadowed(const in FarolArrival arrival, const in vec3 position, const in vec3 origin) {
  vec3 light = arrival.always;
  if (arrival.irradiance == vec3(0.0)) return light;
  vec3 path = arrival.isEndless ? arrival.path : arrival.path + position - origin;
  float reach = length(path);
  float through = farol_transmittance(origin, path / reach, arrival.isEndless ? 1e30 : 0.9999 * reach);
  return light + through * arrival.irradiance;
}

// whether a light's shadows have soft edges
bool farol_isSoft(const in int light) {
  return farol_table(farol_lights, 9 * light).w >= 3.0 || farol_table(farol_lights, 9 * light + 3).z > 0.0;
}

// range in the list of lights that reach a point: those without a range, then those of its cell
ivec2 farol_lightList(const in vec3 position) {
  ivec3 cell = clamp(ivec3((position - farol_gridLeast) * farol_gridScale), ivec3(0), farol_grid - 1);
  return ivec2(farol_table(farol_cells, cell.x + farol_grid.x * (cell.y + farol_grid.y * cell.z)).xy);
}

int farol_listedLight(const in ivec2 list, const in int i) {
  if (i < farol_endlessLights) return i;
  int entry = list.x + i - farol_endlessLights;
  return int(farol_table(farol_cellLights, entry >> 2)[entry & 3]);
}
