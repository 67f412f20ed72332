import type { ValuesOf } from '@farol/editing/fields';
import { LateCode } from '../../base/LateCode';
import { type skyFields, skiesWithSun, type SkyPreset } from '../pictureFields';
import { type DaySky, MOONRISE, NIGHT } from './daySky';
import type { Sky, SunPlace } from './makeSky';

type SkySettings = Readonly<ValuesOf<typeof skyFields>>;
const late = new LateCode(
  () => import('./makeSky'),
  'The code of skies could not be fetched: see that the network is there, and choose one again.',
);

/** The sky of a scene's settings, repainted when they change. */
export class SkySource {
  /**
   * Resolves when the sky requested last is painted; rejects when its late code could not be fetched. Null before the
   * first wait.
   */
  ready: Promise<void> | null = null;
  private made: Sky | null = null;
  private key = '';

  /** @param came - called once the late code is loaded, when the sky can be painted */
  constructor(private readonly came: () => void) {}

  /**
   * Sky of a day if given, else of the settings; null for none, and until its late code is loaded. A changed day is
   * repainted.
   */
  of(settings: SkySettings, day: DaySky | null): Sky | null {
    const key = day ? keyOfDay(day) : keyOf(settings);
    if (key === this.key) return this.made;
    if (key !== '' && late.code === null) {
      this.ready = late.load().then(this.came);
      // callers that await `ready` get the error
      this.ready.catch(() => {});
      return null;
    }
    this.dispose();
    this.key = key;
    if (key !== '') this.made = day ? late.code!.makeDaySky(day) : make(settings, late.code!);
    return this.made;
  }

  dispose(): void {
    this.made?.texture.dispose();
    this.made = null;
    this.key = '';
  }
}

const stepsOf = (angle: number, degrees: number): number => Math.round((angle * 180) / Math.PI / degrees);

/**
 * Key of a day, rounded so that its sky is repainted for each quarter of a degree of the sun; at night for each degree
 * of the moon, since stars take longer to paint.
 */
function keyOfDay({ sun, moon, lit }: DaySky): string {
  if (sun.elevation > NIGHT) return ['day', stepsOf(sun.azimuth, 0.25), stepsOf(sun.elevation, 0.25)].join(' ');
  const moonKey = moon.elevation < MOONRISE ? 'down' : [moon.azimuth, moon.elevation].map((each) => stepsOf(each, 1));
  return ['night', stepsOf(Math.max(sun.elevation, -0.3), 0.5), moonKey, lit.toFixed(2)].join(' ');
}

function keyOf(settings: SkySettings): string {
  const { background, sky, skyTop, skyHorizon, skyGround } = settings;
  if (background === 'sky') {
    const sun = sunOf(settings);
    return sun ? [sky, sun.azimuth, sun.elevation].join(' ') : sky;
  }
  return background === 'gradient' ? [skyTop, skyHorizon, skyGround].join(' ') : '';
}

/** Sun position from the settings; null when the preset decides, or has no sun. */
function sunOf({ placeSun, sky, sunAzimuth, sunElevation }: SkySettings): SunPlace | null {
  const hasSun = (skiesWithSun as readonly SkyPreset[]).includes(sky);
  return placeSun && hasSun ? { azimuth: sunAzimuth, elevation: sunElevation } : null;
}

function make(settings: SkySettings, { makePresetSky, makeGradientSky }: typeof import('./makeSky')): Sky {
  const { background, sky, skyTop: top, skyHorizon: horizon, skyGround: ground } = settings;
  return background === 'sky' ? makePresetSky(sky, sunOf(settings)) : makeGradientSky({ top, horizon, ground });
}
