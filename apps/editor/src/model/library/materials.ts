import type { FieldValue, Vector3Tuple } from '@farol/engine/fields';

type Values = Readonly<Record<string, FieldValue>>;

const metal = (colour: Vector3Tuple, roughness: number): Values => ({ colour, roughness, metalness: 1 });
const matt = (colour: Vector3Tuple, roughness = 0.9): Values => ({ colour, roughness });
const shining = (emissive: Vector3Tuple, emissiveIntensity: number): Values => ({
  colour: [0.1, 0.1, 0.1],
  emissive,
  emissiveIntensity,
});
/** A material with a procedural texture and its normal map. @param repeat - number of repetitions along U */
const textured = (map: string, repeat = 1, roughness = 0.9, repeatV = repeat): Values => {
  // defaults are left out, as stored assets leave them out
  const repeated: Values = repeat === 1 ? {} : { mapRepeatX: repeat, normalMapRepeatX: repeat };
  const repeatedV: Values = repeatV === 1 ? {} : { mapRepeatY: repeatV, normalMapRepeatY: repeatV };
  return { colour: [1, 1, 1], map, normalMap: `${map}-normal`, roughness, ...repeated, ...repeatedV };
};

/** Materials of the library by their English names: values that differ from a material asset's defaults. */
export const libraryMaterials = {
  'Cast iron': { colour: [0.07, 0.073, 0.08], roughness: 0.5, metalness: 0.5 },
  Steel: metal([0.56, 0.57, 0.58], 0.35),
  Brass: metal([0.8, 0.58, 0.25], 0.3),
  Copper: metal([0.82, 0.42, 0.28], 0.32),
  Gold: metal([1, 0.71, 0.29], 0.2),
  Chrome: metal([0.75, 0.76, 0.78], 0.08),
  Enamel: matt([0.85, 0.83, 0.78], 0.25),
  Wax: matt([0.86, 0.78, 0.6], 0.55),
  Glass: {
    ...{ colour: [0.9, 0.95, 1], roughness: 0.08, transparent: true, opacity: 0.25, depthWrite: false },
  },
  'Warm glow': shining([1, 0.62, 0.3], 5),
  'White glow': shining([1, 0.93, 0.84], 5),
  'Daylight glow': shining([0.72, 0.86, 1], 4),
  'Red glow': shining([1, 0.05, 0.06], 6),
  'Blue glow': shining([0.08, 0.3, 1], 6),
  Flame: shining([1, 0.42, 0.1], 9),
  Wood: textured('wood', 1, 0.7),
  Bark: matt([0.16, 0.1, 0.06], 0.95),
  Leaves: matt([0.08, 0.2, 0.05], 0.85),
  Needles: matt([0.03, 0.12, 0.06], 0.9),
  Plaster: textured('plaster', 2),
  Brick: textured('brick', 2),
  Stone: textured('stone', 2),
  Marble: textured('marble', 1, 0.25),
  Asphalt: matt([0.045, 0.046, 0.05], 0.85),
  'Wet asphalt': matt([0.02, 0.021, 0.024], 0.22),
  Paving: textured('stone', 10, 0.85, 1.5),
  Grass: textured('grass', 12, 0.95),
  'Red cloth': textured('cloth-red', 3, 0.95),
  Rubber: matt([0.02, 0.02, 0.02], 0.8),
  Ice: { ...{ kind: 'physical', colour: [0.85, 0.94, 1], roughness: 0.15, transmission: 0.8, ior: 1.31 } },
  'Car paint': {
    ...{ kind: 'physical', colour: [0.45, 0.01, 0.015], roughness: 0.35, metalness: 0.3, clearcoat: 1 },
  },
} as const satisfies Readonly<Record<string, Values>>;

export type LibraryMaterial = keyof typeof libraryMaterials;
