import { gridCode } from './techniqueCode';
import type { Technique } from '../frame/Technique';

/** Not a technique but the choice of one, by `TechniqueChooser`, anew for each frame. */
export const auto: Technique = {
  label: 'Automatic',
  help: 'Picks the fastest technique for what is in view, and says why.',
  lightOrder: 'by-volume',
  needsFloatTargets: false,
  // most scenes are drawn by it: fetched ahead
  lazy: gridCode,
  // it picks one that writes what an effect works on
  writes: ['gbuffer'],
  passes() {
    throw new Error('Farol: "auto" has no passes; those of the technique that it picks draw.');
  },
};
