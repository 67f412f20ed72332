import type { Vector3Tuple } from '@farol/editing/fields';
import { type DaySky, MOONRISE, NIGHT, type SkyDirection } from './daySky';
import { type SkyDisc, type SkyLook, skyLooks } from './skyLooks';

const RADIANS = Math.PI / 180;
const { night, sunset } = skyLooks;
const day = skyLooks['clear-day'];

type Colours = Pick<SkyLook, 'top' | 'horizon' | 'ground'>;

/** Colours of the sky by the sun's elevation (degrees), ascending. */
const stages: readonly (readonly [number, Colours])[] = [
  [-16, night],
  [-8, { top: [0.012, 0.022, 0.07], horizon: [0.1, 0.085, 0.12], ground: [0.012, 0.012, 0.015] }],
  [-3, { top: [0.035, 0.06, 0.18], horizon: [0.34, 0.2, 0.19], ground: [0.03, 0.027, 0.03] }],
  [2, sunset],
  [12, { top: [0.09, 0.18, 0.42], horizon: [0.62, 0.58, 0.56], ground: [0.13, 0.115, 0.1] }],
  [35, day],
];

const mix = (a: Vector3Tuple, b: Vector3Tuple, share: number): Vector3Tuple => [
  a[0] + (b[0] - a[0]) * share,
  a[1] + (b[1] - a[1]) * share,
  a[2] + (b[2] - a[2]) * share,
];
const scale = (a: Vector3Tuple, factor: number): Vector3Tuple => mix([0, 0, 0], a, factor);
const between = (from: number, to: number, value: number): number =>
  Math.min(1, Math.max(0, (value - from) / (to - from)));

function coloursAt(elevation: number): Colours {
  const next = stages.findIndex(([limit]) => elevation < limit);
  if (next === 0) return stages[0][1];
  if (next < 0) return stages.at(-1)![1];
  const [from, low] = stages[next - 1];
  const [to, high] = stages[next];
  const share = between(from, to, elevation);
  return {
    top: mix(low.top, high.top, share),
    horizon: mix(low.horizon, high.horizon, share),
    ground: mix(low.ground, high.ground, share),
  };
}

/** The sun's disc and glow; the glow fades after sunset. */
function sunDisc(sun: SkyDirection): SkyDisc {
  const degrees = sun.elevation / RADIANS;
  const [low, high] = [sunset.disc!, day.disc!];
  const share = between(3, 20, degrees);
  const fading = between(-8, 0, degrees);
  return {
    ...sun,
    radius: high.radius,
    colour: mix(low.colour, high.colour, share),
    glow: scale(mix(low.glow, high.glow, share), fading),
    haze: scale(mix(low.haze, high.haze, share), fading),
  };
}

/** Look of a cloudless sky, with the sun or, after sunset, the moon. */
export function dayLook({ sun, moon, lit }: DaySky): SkyLook {
  const degrees = sun.elevation / RADIANS;
  const isNight = sun.elevation <= NIGHT;
  const moonDisc = night.disc!;
  const shine = {
    colour: scale(moonDisc.colour, lit),
    glow: scale(moonDisc.glow, lit),
    haze: scale(moonDisc.haze, lit),
  };
  const hasMoon = isNight && moon.elevation >= MOONRISE;
  return {
    ...coloursAt(degrees),
    disc: hasMoon ? { ...moonDisc, ...moon, ...shine } : isNight ? null : sunDisc(sun),
    clouds: null,
    stars: Math.round(night.stars * between(-6, -13, degrees)),
    boxes: [],
  };
}
