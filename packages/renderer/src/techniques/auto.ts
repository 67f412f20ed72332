import { gridCode } from './techniqueCode';
import type { Technique } from '../frame/Technique';

/** The technique 'auto': `TechniqueChooser` picks another technique for each frame. */
export const auto: Technique = {
  label: 'Automatic',
  help: 'Picks the fastest technique for what is in view, and says why.',
  lightOrder: 'by-volume',
  needsFloatTargets: false,
  // lists of clusters, fetched ahead since the techniques of most scenes need them
  lazy: gridCode,
  // where an effect reads the G-buffer, the chooser picks a technique that writes it
  writes: ['gbuffer'],
  passes() {
    throw new Error('Farol: "auto" has no passes of its own; ask the technique that it picks.');
  },
};
