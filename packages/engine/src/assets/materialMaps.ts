import { angle, asset, choice, type FieldTable, number } from '@farol/editing/fields';
import type { materialKinds } from './materialFields';

type Kind = (typeof materialKinds)[number];

/** A texture property of three's materials, such as `normalMap`. */
export interface MaterialMap {
  /** Name of the texture property of three's material. */
  readonly property: string;
  readonly label: string;
  readonly help: string;
  /** Kinds of material that have this map. */
  readonly kinds: readonly Kind[];
  /** Whether the texture holds colours, stored as sRGB; otherwise data, which are linear. */
  readonly isColour?: boolean;
  /** Whether the texture holds normals in tangent space. */
  readonly isNormals?: boolean;
}

const all: readonly Kind[] = ['standard', 'physical', 'phong', 'lambert', 'basic'];
const lit: readonly Kind[] = ['standard', 'physical', 'phong', 'lambert'];
const pbr: readonly Kind[] = ['standard', 'physical'];
const physical: readonly Kind[] = ['physical'];

/** Every map of three's mesh materials, by the name of the field. */
export const materialMaps = {
  map: { property: 'map', label: 'Colour map', help: 'Texture of the colour.', kinds: all, isColour: true },
  alphaMap: { property: 'alphaMap', label: 'Alpha map', help: 'Opacity, in green.', kinds: all },
  normalMap: {
    property: 'normalMap',
    label: 'Normal map',
    help: 'Normals in tangent space.',
    kinds: lit,
    isNormals: true,
  },
  bumpMap: {
    property: 'bumpMap',
    label: 'Bump map',
    help: 'Heights: white is high. Ignored where there is a normal map.',
    kinds: lit,
  },
  displacementMap: {
    property: 'displacementMap',
    label: 'Displacement map',
    help: 'Heights by which vertices are moved along their normals.',
    kinds: lit,
  },
  roughnessMap: {
    property: 'roughnessMap',
    label: 'Roughness map',
    help: 'Factor of the roughness, in green.',
    kinds: pbr,
  },
  metalnessMap: {
    property: 'metalnessMap',
    label: 'Metalness map',
    help: 'Factor of the metalness, in blue.',
    kinds: pbr,
  },
  specularMap: {
    property: 'specularMap',
    label: 'Specular map',
    help: 'Strength of the highlight, in red.',
    kinds: ['phong', 'lambert', 'basic'],
  },
  aoMap: { property: 'aoMap', label: 'Occlusion map', help: 'How much ambient light arrives, in red.', kinds: all },
  lightMap: {
    property: 'lightMap',
    label: 'Light map',
    help: 'Baked light; most models keep it in UV channel 1.',
    kinds: all,
    isColour: true,
  },
  emissiveMap: {
    property: 'emissiveMap',
    label: 'Emissive map',
    help: 'Multiplies the emissive colour.',
    kinds: lit,
    isColour: true,
  },
  clearcoatMap: {
    property: 'clearcoatMap',
    label: 'Clearcoat map',
    help: 'Factor of the clearcoat, in red.',
    kinds: physical,
  },
  clearcoatRoughnessMap: {
    property: 'clearcoatRoughnessMap',
    label: 'Clearcoat roughness map',
    help: 'Factor of the roughness of the clearcoat, in green.',
    kinds: physical,
  },
  clearcoatNormalMap: {
    property: 'clearcoatNormalMap',
    label: 'Clearcoat normal map',
    help: 'Normals of the clearcoat, in tangent space.',
    kinds: physical,
    isNormals: true,
  },
  sheenColourMap: {
    property: 'sheenColorMap',
    label: 'Sheen colour map',
    help: 'Multiplies the colour of the sheen.',
    kinds: physical,
    isColour: true,
  },
  sheenRoughnessMap: {
    property: 'sheenRoughnessMap',
    label: 'Sheen roughness map',
    help: 'Factor of the roughness of the sheen, in alpha.',
    kinds: physical,
  },
  iridescenceMap: {
    property: 'iridescenceMap',
    label: 'Iridescence map',
    help: 'Factor of the iridescence, in red.',
    kinds: physical,
  },
  iridescenceThicknessMap: {
    property: 'iridescenceThicknessMap',
    label: 'Film thickness map',
    help: 'Thickness of the film between its least and its greatest, in green.',
    kinds: physical,
  },
  anisotropyMap: {
    property: 'anisotropyMap',
    label: 'Anisotropy map',
    help: 'Direction in red and green, strength in blue.',
    kinds: physical,
  },
  transmissionMap: {
    property: 'transmissionMap',
    label: 'Transmission map',
    help: 'Factor of the transmission, in red.',
    kinds: physical,
  },
  diffuseRoughnessMap: {
    property: 'diffuseRoughnessMap',
    label: 'Diffuse roughness map',
    help: 'Factor of the diffuse roughness, in red.',
    kinds: physical,
  },
  thicknessMap: {
    property: 'thicknessMap',
    label: 'Thickness map',
    help: 'Factor of the thickness, in green.',
    kinds: physical,
  },
  specularIntensityMap: {
    property: 'specularIntensityMap',
    label: 'Specular map of dielectrics',
    help: 'Factor of the specular intensity, in alpha.',
    kinds: physical,
  },
  specularColourMap: {
    property: 'specularColorMap',
    label: 'Specular colour map',
    help: 'Multiplies the specular colour.',
    kinds: physical,
    isColour: true,
  },
} as const satisfies Readonly<Record<string, MaterialMap>>;

/** Names of fields for the maps of three's mesh materials. */
export type MaterialMapName = keyof typeof materialMaps;

/** Names of fields for the maps of three's mesh materials, in the order of the inspector. */
export const materialMapNames = Object.keys(materialMaps) as readonly MaterialMapName[];

/** Wrapping of a texture beyond its edges. */
export const wrapModes = ['repeat', 'mirror', 'clamp'] as const;

/** Endings of the names of fields that place a map on the surface, such as 'RepeatX' in 'normalMapRepeatX'. */
export const uvFieldEndings = [
  'OffsetX',
  'OffsetY',
  'RepeatX',
  'RepeatY',
  'Rotation',
  'WrapX',
  'WrapY',
  'Channel',
] as const;

/** Fields of one map: its texture, and the texture's placement on the surface. */
export function fieldsOfMap(name: MaterialMapName): FieldTable {
  const { label, help, kinds } = materialMaps[name] as MaterialMap;
  const shown = kinds.length === all.length ? {} : { visibleWhen: { field: 'kind', equals: kinds } };
  return {
    [name]: asset('texture', null, { label, help, ...shown }),
    [`${name}OffsetX`]: number(0, {
      label: 'Offset U',
      step: 0.01,
      help: 'Moves the map along U, in widths of the texture.',
      ...shown,
    }),
    [`${name}OffsetY`]: number(0, {
      label: 'Offset V',
      step: 0.01,
      help: 'Moves the map along V, in heights of the texture.',
      ...shown,
    }),
    [`${name}RepeatX`]: number(1, {
      label: 'Repeat U',
      step: 0.1,
      help: 'How many times the map repeats along U; below 0 it is mirrored.',
      ...shown,
    }),
    [`${name}RepeatY`]: number(1, {
      label: 'Repeat V',
      step: 0.1,
      help: 'How many times the map repeats along V; below 0 it is mirrored.',
      ...shown,
    }),
    [`${name}Rotation`]: angle(0, {
      label: 'Rotation',
      help: 'Turns the map about the corner where U and V are 0.',
      ...shown,
    }),
    [`${name}WrapX`]: choice('repeat', wrapModes, {
      label: 'Wrap U',
      help: 'What is beyond the left and right edges of the texture.',
      ...shown,
    }),
    [`${name}WrapY`]: choice('repeat', wrapModes, {
      label: 'Wrap V',
      help: 'What is beyond the lower and upper edges of the texture.',
      ...shown,
    }),
    [`${name}Channel`]: number(0, {
      label: 'UV channel',
      min: 0,
      max: 3,
      step: 1,
      integer: true,
      help: 'UV channel of the mesh; a mesh without it shows one texel.',
      ...shown,
    }),
  };
}
