import { angle, colour, number } from '@farol/editing/fields';
import { declare } from './declare';

/** Properties of lights; a light shows those that its three class has. */
export const lightProperties = [
  declare('color', colour([1, 1, 1], { label: 'Colour', help: 'Colour of the light.' })),
  declare('groundColor', colour([1, 1, 1], { label: 'Ground colour', help: 'Colour of the light from below.' })),
  declare(
    'intensity',
    number(1, { min: 0, step: 0.1, help: 'Candela for point and spot lights, lux for directional ones.' }),
  ),
  declare('distance', number(0, { min: 0, unit: 'm', step: 0.1, help: 'Reach; 0 for no end.' })),
  declare('decay', number(2, { min: 0, step: 0.1, help: 'How fast it fades with distance; 2 is physical.' })),
  declare('angle', angle(Math.PI / 3, { min: 0, max: Math.PI / 2, help: 'From the axis to the edge of the cone.' })),
  declare('penumbra', number(0, { min: 0, max: 1, step: 0.05, help: 'Share of the cone that fades out.' })),
  declare('width', number(10, { min: 0, unit: 'm', step: 0.1, help: 'Width of the area.' })),
  declare('height', number(10, { min: 0, unit: 'm', step: 0.1, help: 'Height of the area.' })),
];
