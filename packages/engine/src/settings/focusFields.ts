import { type FieldCondition, number } from '@farol/editing/fields';

/** Depth-of-field fields, for the scene's settings and for a camera. @param shown - condition for showing them */
export const focusFields = (shown: { readonly visibleWhen: FieldCondition }) => ({
  focusDistance: number(10, {
    unit: 'm',
    min: 0.01,
    help: 'Distance from the camera at which things are sharp.',
    label: 'Focus distance',
    ...shown,
  }),
  focusRange: number(5, {
    unit: 'm',
    min: 0.01,
    help: 'How far from the focus things are as blurred as they become.',
    label: 'Focus range',
    ...shown,
  }),
  focusBlur: number(2, {
    min: 0,
    max: 10,
    step: 0.1,
    help: 'How blurred things far from the focus are.',
    label: 'Blur strength',
    ...shown,
  }),
});
