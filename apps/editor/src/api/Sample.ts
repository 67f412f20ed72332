import { type SceneDefinition, scenes } from '@farol/scenes';

/** A sample scene, offered on the welcome page and in the File menu. */
export interface Sample {
  /** Unique name of the sample, and file name of its thumbnail. */
  readonly name: string;
  /** Label of the sample, in English. */
  readonly label: string;
  /** Hint on something to try in the sample, in English. */
  readonly help: string;
  /** File name in `public/scenes`; null for a demo scene of the engine. */
  readonly file: string | null;
  /** Demo scene of the engine; null for a file. */
  readonly scene: SceneDefinition | null;
}

const ofFile = (file: string, label: string, help: string): Sample => ({
  name: file.slice(0, file.lastIndexOf('.')),
  ...{ label, help, file, scene: null },
});

/** Samples in files of `public/scenes`. */
const ofFiles: readonly Sample[] = [
  ofFile(
    'night-in-the-temple.farol',
    'Night in the temple',
    'Play, then walk up the steps. The door opens when you come near; push the crates.',
  ),
  ofFile(
    'foggy-street.farol',
    'Foggy street',
    'Lamps, the moon and a car in fog. Play; then open Frame and change the density of “Volumetric fog”.',
  ),
  ofFile(
    'fire.json',
    'Fire and sparks',
    'Every spark is a light. Select “Sparks” and watch; change its rate, its curves, and what it lights.',
  ),
  ofFile(
    'baked-room.farol',
    'Baked room',
    'Light that was baked, and a ball that moves through it. Play; then change a lamp, and bake again.',
  ),
  ofFile(
    'animation.json',
    'Animation',
    'A fairground of clips. Open the Timeline, move keys of “Arm reaches”, and play.',
  ),
  ofFile(
    'physics.json',
    'Physics',
    'Play: a ball on a chain knocks down a wall. Change masses, joints and bounciness.',
  ),
  ofFile(
    'scripts.json',
    'Scripts',
    'Play, then edit “Wave” in the Scripts panel: it changes while it runs. F stops the fountain.',
  ),
  ofFile('prefabs.json', 'Prefabs', 'A street of lamps and benches. Change one lamp, then “Apply all to prefab”.'),
  ofFile(
    'microshaders.json',
    'Microshaders',
    'Light in bands and rings. Edit “lightAttenuation” in the Microshaders panel.',
  ),
  ofFile(
    'shading.json',
    'Shading models',
    'Flat, Gouraud and Phong side by side. Move the lamp, and choose another in the field “Shading” of a ball.',
  ),
  ofFile(
    'surfaces.json',
    'Surfaces',
    'Play: waves, embers, rust and a hologram. Select a material in Assets, and move its values.',
  ),
];

/** All samples by name, in display order. */
export const samples: Readonly<Record<string, Sample>> = Object.fromEntries(
  [
    ...ofFiles,
    ...Object.values(scenes).map((scene): Sample => {
      const { name, label, help } = scene;
      return { name, label, help, file: null, scene };
    }),
  ].map((sample) => [sample.name, sample]),
);
