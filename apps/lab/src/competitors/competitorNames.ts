import { type TechniqueName, techniques } from '@farol/renderer';

/**
 * Texts and kind of a competitor. This module runs when the page is built (`valueModules`): the page contains only its
 * values; the code of competitors is in `stage.html`.
 */
export interface CompetitorWords {
  readonly label: string;
  readonly help: string;
  readonly kind: 'farol' | 'three' | 'rival';
}

/** Short name of a technique: its label when key and label have the same words, otherwise the key. */
function shortName(key: string, label: string): string {
  const letters = label
    .toLowerCase()
    .replaceAll('+', 'plus')
    .replaceAll(/[^a-z]/g, '');
  if (letters !== key.replaceAll('-', '')) return key.replaceAll('-', ' ');
  return label.includes('+') ? label : label.charAt(0).toLowerCase() + label.slice(1);
}

const techniqueCompetitors = Object.fromEntries(
  Object.entries(techniques).map(([name, { label, help }]) => [
    name,
    { label: `Farol: ${shortName(name, label)}`, kind: 'farol', help },
  ]),
) as Readonly<Record<TechniqueName, CompetitorWords>>;

/** Competitors by key, in the order of menus and charts: Farol's techniques, then the others. */
export const competitorNames = {
  ...techniqueCompetitors,
  lite: { label: 'Farol: lite', kind: 'farol', help: 'Automatic, with the quality ‘lite’.' },
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
