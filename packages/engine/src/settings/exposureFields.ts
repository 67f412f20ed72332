import { choice, type FieldCondition, number, type ValuesOf } from '@farol/editing/fields';
import { evOfCamera, exposureOfEV } from '../photometry/exposure';

const by = (way: string): { visibleWhen: FieldCondition } => ({
  visibleWhen: { field: 'exposureBy', equals: [way] },
});

/**
 * Exposure fields, for the scene's settings and for a camera.
 * @param first - first option of `exposureBy`: 'factor', or 'scene' for a camera @param label - label of that option
 */
export const exposureFields = <First extends string>(first: First, label: string) => ({
  exposureBy: choice<First | 'value' | 'camera' | 'automatic'>(first, [first, 'value', 'camera', 'automatic'], {
    help: 'By a factor, an exposure value, aperture, time and ISO as a camera has them, or by how bright the picture is.',
    label: 'Exposure by',
    optionLabels: {
      [first]: label,
      value: 'Exposure value',
      camera: 'Aperture, time, ISO',
      automatic: 'Automatic',
    } as {
      [Way in First | 'value' | 'camera' | 'automatic']?: string;
    },
  }),
  exposureValue: number(0, {
    unit: 'EV',
    min: -20,
    max: 30,
    step: 0.1,
    help: 'Exposure value at ISO 100: 15 for sunlight, 6 for a lit room, 0 where 1 cd/m² is nearly white.',
    label: 'Exposure value',
    ...by('value'),
  }),
  aperture: number(2.8, {
    min: 0.5,
    max: 64,
    step: 0.1,
    help: 'f-number: the smaller, the brighter.',
    ...by('camera'),
  }),
  shutterTime: number(1 / 60, {
    unit: 's',
    min: 1e-5,
    max: 60,
    step: 0.001,
    help: 'How long the shutter is open: twice the time is twice the light.',
    label: 'Shutter time',
    ...by('camera'),
  }),
  iso: number(800, {
    min: 1,
    max: 1e6,
    step: 100,
    help: 'Speed of the sensor: twice the number is twice the light.',
    label: 'ISO',
    ...by('camera'),
  }),
  exposureLeast: number(-6, {
    unit: 'EV',
    min: -20,
    max: 30,
    step: 0.1,
    help: 'Exposure value below which a dark picture is made no brighter.',
    label: 'Lowest',
    ...by('automatic'),
  }),
  exposureMost: number(17, {
    unit: 'EV',
    min: -20,
    max: 30,
    step: 0.1,
    help: 'Exposure value above which a bright picture is made no darker.',
    label: 'Highest',
    ...by('automatic'),
  }),
  exposureTime: number(0.5, {
    unit: 's',
    min: 0,
    max: 60,
    step: 0.1,
    help: 'Time in which most of a change of light is made up for while the scene plays; 0 for at once.',
    label: 'Adaptation time',
    ...by('automatic'),
  }),
});

type Exposure = Readonly<ValuesOf<ReturnType<typeof exposureFields>>>;

/** Factor of a picture's light by exposure value or camera settings; null for other options of `exposureBy`. */
export function exposureOf({ exposureBy, exposureValue, aperture, shutterTime, iso }: Exposure): number | null {
  if (exposureBy === 'value') return exposureOfEV(exposureValue);
  return exposureBy === 'camera' ? exposureOfEV(evOfCamera(aperture, shutterTime, iso)) : null;
}
