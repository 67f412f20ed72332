import { type SceneParameters, scenes } from '@farol/engine/scenes';

/** A scene to look at and to learn from. */
export interface Sample {
  /** Also that of its picture. */
  readonly name: string;
  /** In English. */
  readonly label: string;
  /** What to try, in English. */
  readonly help: string;
  /** Its file in `public/scenes`; null for a scene that the engine makes. */
  readonly file: string | null;
  /** With what the engine makes it. */
  readonly parameters: SceneParameters;
}

const ofFile = (file: string, label: string, help: string): Sample => ({
  name: file.slice(0, file.lastIndexOf('.')),
  ...{ label, help, file, parameters: {} },
});

/** Files that `packages/tools/makeSamples.mjs` writes. */
const ofFiles: readonly Sample[] = [
  ofFile('prefabs.json', 'Prefabs', 'A street of lamps and benches. Change one lamp, then “Apply all to prefab”.'),
  ofFile(
    'microshaders.json',
    'Microshaders',
    'Light in bands and rings. Edit “lightAttenuation” in the Microshaders panel.',
  ),
];

/** All samples by name, in the order in which they are shown. */
export const samples: Readonly<Record<string, Sample>> = Object.fromEntries(
  [
    ...ofFiles,
    ...Object.values(scenes).map(({ name, label, help, sample }): Sample => ({
      name,
      label,
      help,
      file: null,
      parameters: sample,
    })),
  ].map((sample) => [sample.name, sample]),
);
