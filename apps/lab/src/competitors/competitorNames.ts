/** Competitors in the order of menus and colours. The page knows names and words; `stage.html` alone holds their code. */
export interface CompetitorWords {
  readonly label: string;
  readonly help: string;
  readonly kind: 'farol' | 'three' | 'rival';
}

/** Words of the competitors, by key. */
export const competitorNames = {
  auto: { label: 'Farol: auto', kind: 'farol', help: 'Picks a technique for the scene on show.' },
  forward: {
    label: 'Farol: forward',
    kind: 'farol',
    help: 'One additive pass over an object for each light, as in the thesis.',
  },
  'forward-single-pass': {
    label: 'Farol: forward, single pass',
    kind: 'farol',
    help: 'All lights in one loop of the object’s shader.',
  },
  deferred: { label: 'Farol: deferred', kind: 'farol', help: 'A G-buffer, then a volume for each light.' },
  'light-prepass': {
    label: 'Farol: light pre-pass',
    kind: 'farol',
    help: 'Normals first, light into a buffer, then the objects once more.',
  },
  inferred: { label: 'Farol: inferred', kind: 'farol', help: 'A light pre-pass at a lower resolution.' },
  'tiled-deferred': {
    label: 'Farol: tiled deferred',
    kind: 'farol',
    help: 'A G-buffer, then lists of lights for tiles of the picture.',
  },
  'tiled-forward': {
    label: 'Farol: tiled forward',
    kind: 'farol',
    help: 'Lists of lights for tiles, read while objects are drawn.',
  },
  'forward-plus': {
    label: 'Farol: Forward+',
    kind: 'farol',
    help: 'Depth first, then tiled forward with lists cut by depth.',
  },
  'clustered-deferred': {
    label: 'Farol: clustered deferred',
    kind: 'farol',
    help: 'A G-buffer, lists by tile and depth.',
  },
  'clustered-forward': {
    label: 'Farol: clustered forward',
    kind: 'farol',
    help: 'Lists by tile and depth, read while objects are drawn.',
  },
  stock: {
    label: 'three: WebGLRenderer',
    kind: 'three',
    help: 'All lights as uniforms of one loop; compiled anew for each number of lights.',
  },
  multipass: {
    label: 'three: naive multipass',
    kind: 'three',
    help: 'The whole scene drawn once more, additively, for each light.',
  },
  'three-webgpu': {
    label: 'three: WebGPU, clustered',
    kind: 'three',
    help: 'WebGPURenderer with the ClusteredLighting addon.',
  },
  playcanvas: { label: 'PlayCanvas, clustered', kind: 'rival', help: 'PlayCanvas’s clustered lights on WebGL 2.' },
  babylon: { label: 'Babylon.js, clustered', kind: 'rival', help: 'Babylon’s ClusteredLightContainer on WebGL 2.' },
} as const satisfies Record<string, CompetitorWords>;

export type CompetitorName = keyof typeof competitorNames;
