import { angle, boolean, choice, number } from '@farol/editing/fields';
import { Quaternion, Vector3 } from 'three';
import { MOON_KELVIN, moonIlluminance, skyIlluminance, sunIlluminance, sunKelvin } from '../astronomy/daylight';
import { julianDay, type MoonPlace, moonPlace, type SkyPlace, sunPlace } from '../astronomy/sunAndMoon';
import { component } from '../core/Component';
import type { NewObject } from '../core/NewObject';
import type { Scene } from '../core/Scene';
import { lightOfKelvin } from '../photometry/colourTemperature';
import type { SkyDirection } from '../settings/sky/daySky';
import { Light } from './Light';
import { sunShadows } from './newShadows';

/** Hours within which changes of light and shadows are invisible: the sun moves by 0.03°. */
const STEP = 0.002;
/** Intensities of the sun overhead and of a full moon, for scenes without photometric light. */
const SCREEN_SUN = 3;
const SCREEN_MOON = 0.25;
const FULL_SUN = sunIlluminance(Math.PI / 2);
const FULL_MOON = moonIlluminance(Math.PI / 2, 0);

const front = new Vector3(0, 0, 1);
const toLight = new Vector3();
const parent = new Quaternion();

const place = { group: 'Place' };

/**
 * Sun, moon and sky at an hour and a place on earth: turns its object, gives the object's Light the colour and
 * intensity of the sun or, at night, of the moon, and shows the sky, whose light is the ambient one. None of that is an
 * edit. North is -Z, east +X.
 */
export class SunAndMoon extends component({
  hour: number(16, {
    unit: 'h',
    min: 0,
    max: 24,
    step: 0.05,
    help: 'Hour of the day by the clock of the time zone.',
  }),
  day: number(21, { min: 1, max: 31, integer: true, help: 'Day of the month.' }),
  month: number(6, { min: 1, max: 12, integer: true, help: 'Month of the year.' }),
  year: number(2026, { min: 1900, max: 2100, integer: true, help: 'Year of the Gregorian calendar.' }),
  latitude: angle((40.42 * Math.PI) / 180, {
    min: -Math.PI / 2,
    max: Math.PI / 2,
    help: 'Above 0 north of the equator.',
    ...place,
  }),
  longitude: angle((-3.7 * Math.PI) / 180, {
    min: -Math.PI,
    max: Math.PI,
    help: 'Above 0 east of Greenwich.',
    ...place,
  }),
  timeZone: number(2, {
    unit: 'h',
    min: -12,
    max: 14,
    step: 0.5,
    help: 'Hours that clocks are ahead of universal time, summer time included.',
    label: 'Time zone',
    ...place,
  }),
  north: angle(0, { min: -Math.PI, max: Math.PI, help: 'Turns the compass: at 0 north is towards -Z.', ...place }),
  brightness: choice('screen', ['screen', 'measured'], {
    help: 'As suits a screen without exposure, or in lux as measured, for a camera with exposure.',
    optionLabels: { screen: 'For a screen', measured: 'As measured' },
  }),
  sky: boolean(true, { help: 'Show the sky of the hour, which lights the scene too.', label: 'Show the sky' }),
  speed: number(0, {
    unit: 'h/s',
    min: 0,
    max: 24,
    step: 0.05,
    help: 'Hours that pass in a second while the scene plays.',
  }),
}) {
  static override readonly typeName: string = 'SunAndMoon';
  static override readonly icon: string = 'directional';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'Sun, moon and sky of a date, an hour and a place.';
  static override readonly newObjects: readonly NewObject[] = [
    {
      label: 'Sun and moon',
      group: 'light',
      icon: 'directional',
      with: [Light, { type: 'directional', ...sunShadows(50) }],
    },
  ];

  private shownHour = Number.NaN;
  private end: (() => void) | null = null;
  /** Whether this component sets the scene's sky: the first active one does. */
  private showsSky = false;

  /** Position of the sun at the current hour; azimuth from north. */
  get sun(): SkyPlace {
    return sunPlace(this.julianDay, this);
  }

  get moon(): MoonPlace {
    return moonPlace(this.julianDay, this);
  }

  override onEnterScene(scene: Scene): void {
    this.end = scene.onChange((change) => {
      const isOwn =
        (change.kind === 'field' || change.kind === 'component-add') &&
        change.component !== this &&
        change.component.isAttached &&
        change.component.gameObject === this.gameObject;
      if (isOwn) this.show(this.hourAt(scene.time));
    });
    this.onActiveChanged();
  }

  override onLeaveScene(scene: Scene): void {
    this.end?.();
    this.giveBack(scene);
  }

  override onActiveChanged(): void {
    const { scene } = this;
    if (!scene) return;
    if (this.isActive) this.show(this.hourAt(scene.time));
    else this.giveBack(scene);
  }

  override onFieldChanged(): void {
    this.onActiveChanged();
  }

  override update(deltaSeconds: number, time: number): void {
    const hour = this.hourAt(time);
    if (deltaSeconds === 0 || Math.abs(hour - this.shownHour) > STEP) this.show(hour);
  }

  private hourAt(time: number): number {
    return this.hour + this.speed * time;
  }

  private get julianDay(): number {
    const hour = Number.isNaN(this.shownHour) ? this.hour : this.shownHour;
    return julianDay(this.year, this.month, this.day, hour - this.timeZone);
  }

  private giveBack(scene: Scene): void {
    this.shownHour = Number.NaN;
    this.gameObject.getComponent(Light)?.setSubstitute(null);
    this.gameObject.transform.restoreAuthored();
    if (this.showsSky) scene.settings.showDay(null);
    this.showsSky = false;
  }

  private show(hour: number): void {
    this.shownHour = hour;
    const { sun, moon } = this;
    const isMeasured = this.brightness === 'measured';
    const sunLight = sunIlluminance(sun.elevation);
    const moonLight = moonIlluminance(moon.elevation, moon.phaseAngle);
    const isDay = sunLight > moonLight;
    this.turn(isDay ? sun : moon);
    const intensity = isDay ? (sunLight / FULL_SUN) * SCREEN_SUN : (moonLight / FULL_MOON) * SCREEN_MOON;
    this.gameObject.getComponent(Light)?.setSubstitute({
      colour: lightOfKelvin(isDay ? sunKelvin(sun.elevation) : MOON_KELVIN),
      intensity: isMeasured ? (isDay ? sunLight : moonLight) : intensity,
    });
    // only one component paints the scene's only sky, which takes milliseconds
    const { scene } = this;
    if (!scene || scene.componentsOf(SunAndMoon).find(({ isActive }) => isActive) !== this) return;
    this.showsSky = true;
    scene.settings.showDay(
      this.sky
        ? {
            ...{ sun: this.inScene(sun), moon: this.inScene(moon), lit: moon.lit },
            illuminance: isMeasured ? skyIlluminance(sun.elevation) : null,
          }
        : null,
    );
  }

  /** Converts a place to the convention of `SkyDirection`: azimuth from +x towards +z. */
  private inScene({ azimuth, elevation }: SkyPlace): SkyDirection {
    return { azimuth: azimuth + this.north - Math.PI / 2, elevation };
  }

  /** Turns the object so that its light, along -Z, comes from a place in the sky. */
  private turn(from: SkyPlace): void {
    const { azimuth, elevation } = this.inScene(from);
    const { object3D } = this.gameObject;
    const level = Math.cos(elevation);
    toLight.set(Math.cos(azimuth) * level, Math.sin(elevation), Math.sin(azimuth) * level);
    object3D.quaternion.setFromUnitVectors(front, toLight);
    const above = object3D.parent;
    if (above) object3D.quaternion.premultiply(above.getWorldQuaternion(parent).invert());
  }
}
