import { t } from '@farol/editing';
import { materialMapNames, surfaceMaps, uvFieldEndings } from '@farol/engine/fields';

export interface MaterialSection {
  /** Key under which the folded state is stored. */
  readonly id: string;
  /** Title in the user's language. */
  title(): string;
  help(): string;
  readonly fields: readonly string[];
  readonly isFoldedAtFirst?: boolean;
  /** Name of a field that, unless 0, makes techniques with a G-buffer draw the material in a forward pass. */
  readonly forward?: string;
}

/** Sections of a material's fields. Each field is in one section, except for UV placement of maps. */
export const materialSections: readonly MaterialSection[] = [
  {
    id: 'Surface',
    title: () => t('Surface'),
    help: () => t('Colour, roughness and metalness.'),
    fields: [
      ...['kind', 'colour', 'map', 'roughness', 'roughnessMap', 'metalness', 'metalnessMap'],
      ...['ambient', 'specular', 'shininess', 'specularMap', 'shading', 'vertexColours'],
    ],
  },
  {
    id: 'Worn surface',
    title: () => t('Surface effect'),
    help: () => t('GLSL of the library that changes colour and shape, and its uniforms.'),
    fields: ['surface', 'surfaceValues', ...surfaceMaps],
  },
  {
    id: 'Relief',
    title: () => t('Relief'),
    help: () => t('Bumps that are drawn, and displacement that moves vertices.'),
    fields: [
      ...['normalMap', 'normalScale', 'normalFlip', 'bumpMap', 'bumpScale'],
      ...['displacementMap', 'displacementScale', 'displacementBias'],
    ],
  },
  {
    id: 'Emission',
    title: () => t('Emission'),
    help: () => t('Light that the surface gives off by itself.'),
    fields: ['emissive', 'emissiveIntensity', 'emissiveMap'],
  },
  {
    id: 'Opacity',
    title: () => t('Opacity'),
    help: () => t('Transparency, and which sides are drawn.'),
    isFoldedAtFirst: true,
    fields: ['transparent', 'opacity', 'alphaMap', 'alphaTest', 'depthWrite', 'doubleSided', 'side', 'wireframe'],
    forward: 'transparent',
  },
  {
    id: 'Baked light',
    title: () => t('Baked light'),
    help: () => t('Occlusion and light that was computed beforehand.'),
    isFoldedAtFirst: true,
    fields: ['aoMap', 'aoIntensity', 'lightMap', 'lightMapIntensity'],
  },
  {
    id: 'Clearcoat',
    title: () => t('Clearcoat'),
    help: () => t('A layer of varnish.'),
    isFoldedAtFirst: true,
    fields: [
      ...['clearcoat', 'clearcoatMap', 'clearcoatRoughness', 'clearcoatRoughnessMap'],
      ...['clearcoatNormalMap', 'clearcoatNormalScale', 'clearcoatNormalFlip'],
    ],
    forward: 'clearcoat',
  },
  {
    id: 'Sheen',
    title: () => t('Sheen'),
    help: () => t('Soft light at grazing angles, as of velvet.'),
    isFoldedAtFirst: true,
    fields: ['sheen', 'sheenColour', 'sheenColourMap', 'sheenRoughness', 'sheenRoughnessMap'],
    forward: 'sheen',
  },
  {
    id: 'Iridescence',
    title: () => t('Iridescence'),
    help: () => t('Colours of a thin film.'),
    isFoldedAtFirst: true,
    fields: [
      ...['iridescence', 'iridescenceMap', 'iridescenceIor'],
      ...['iridescenceThicknessMax', 'iridescenceThicknessMin', 'iridescenceThicknessMap'],
    ],
    forward: 'iridescence',
  },
  {
    id: 'Anisotropy',
    title: () => t('Anisotropy'),
    help: () => t('Highlights that are stretched, as of brushed metal.'),
    isFoldedAtFirst: true,
    fields: ['anisotropy', 'anisotropyRotation', 'anisotropyMap'],
    forward: 'anisotropy',
  },
  {
    id: 'Transmission',
    title: () => t('Transmission'),
    help: () => t('Light that passes through, as through glass and water.'),
    isFoldedAtFirst: true,
    fields: [
      ...['transmission', 'transmissionMap', 'ior', 'thickness', 'thicknessMap'],
      ...['attenuationColour', 'attenuationDistance', 'dispersion'],
    ],
    forward: 'transmission',
  },
  {
    id: 'Reflection',
    title: () => t('Reflection'),
    help: () => t('How non-metals reflect and scatter.'),
    isFoldedAtFirst: true,
    fields: [
      ...['specularIntensity', 'specularIntensityMap', 'specularColour', 'specularColourMap'],
      ...['diffuseRoughness', 'diffuseRoughnessMap', 'retroreflectivity'],
    ],
    forward: 'diffuseRoughness',
  },
];

const maps: ReadonlySet<string> = new Set(materialMapNames);

export const isMapField = (name: string): boolean => maps.has(name);

export const placementFields = (map: string): string[] => uvFieldEndings.map((ending) => map + ending);
