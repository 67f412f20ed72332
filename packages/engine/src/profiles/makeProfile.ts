import { PhotometricProfile } from '@farol/renderer/light-profiles';

/** A luminaire: its intensity by direction (cd), angles in radians. */
interface Luminaire {
  readonly luminaire: string;
  /** Step between horizontal angles, and the greatest of them: 0, 90 or 180 (degrees). */
  readonly step: number;
  readonly end: number;
  readonly intensity: (vertical: number, horizontal: number) => number;
}

const bell = (x: number, width: number): number => Math.exp(-((x / width) ** 2));
const DEGREE = Math.PI / 180;

const luminaires = {
  downlight: {
    luminaire: 'Recessed downlight with a dark reflector, 35° cutoff',
    step: 90,
    end: 0,
    intensity: (v) =>
      2600 * bell(v, 24 * DEGREE) * (1 - smooth(33 * DEGREE, 38 * DEGREE, v)) + 14 * Math.max(0, Math.cos(v)),
  },
  wallWasher: {
    luminaire: 'Wall washer: most light to one side, along 90°',
    step: 10,
    end: 360,
    intensity(v, h) {
      const towards = Math.sin(v) * Math.sin(h);
      const along = Math.sin(v) * Math.cos(h);
      const aim = Math.atan2(towards, Math.cos(v));
      return v >= 90 * DEGREE ? 0 : 1500 * bell(aim - 38 * DEGREE, 26 * DEGREE) * bell(along, 0.62) + 60 * Math.cos(v);
    },
  },
  streetLight: {
    luminaire: 'Street light: two lobes along the street, 0° and 180°, little light back to the houses',
    step: 5,
    end: 360,
    intensity(v, h) {
      if (v >= 90 * DEGREE) return 0;
      const along = Math.abs(Math.atan2(Math.sin(v) * Math.cos(h), Math.cos(v)));
      const side = Math.atan2(Math.sin(v) * Math.sin(h), Math.cos(v));
      const lobes = bell(along - 60 * DEGREE, 17 * DEGREE) + 0.32 * bell(along, 48 * DEGREE);
      const across = bell(side - 18 * DEGREE, side > 18 * DEGREE ? 34 * DEGREE : 26 * DEGREE);
      return 5200 * lobes * across * (1 - smooth(74 * DEGREE, 88 * DEGREE, v));
    },
  },
} satisfies Record<string, Luminaire>;

function smooth(from: number, to: number, x: number): number {
  const share = Math.max(0, Math.min(1, (x - from) / (to - from)));
  return share * share * (3 - 2 * share);
}

export function makeProfile(name: keyof typeof luminaires): PhotometricProfile {
  const { luminaire, step, end, intensity }: Luminaire = luminaires[name];
  const verticalAngles = Float64Array.from({ length: 73 }, (_, i) => i * 2.5);
  const horizontalAngles = Float64Array.from({ length: end / step + 1 }, (_, i) => i * step);
  const candelas = new Float64Array(verticalAngles.length * horizontalAngles.length);
  horizontalAngles.forEach((h, plane) => {
    verticalAngles.forEach((v, i) => {
      candelas[plane * verticalAngles.length + i] = Math.max(0, intensity(v * DEGREE, h * DEGREE));
    });
  });
  const opening = { width: 0.2, length: 0.2, height: 0 };
  const keywords = new Map([
    ['MANUFAC', 'Farol'],
    ['LUMINAIRE', luminaire],
  ]);
  return new PhotometricProfile({
    version: 'LM-63-2019',
    keywords,
    type: 'C',
    lamps: 1,
    lumensPerLamp: -1,
    ...opening,
    inputWatts: 0,
    tilt: null,
    verticalAngles,
    horizontalAngles,
    candelas,
  });
}
