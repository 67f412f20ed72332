import type { LearntChoice } from './learning';
import { arrayCode } from './drawCameras';
import { unknownName } from './errors';
import { lightFieldMade } from '../lights/lightFieldMade';
import { Lazy } from '../frame/Lazy';
import { gridCode, lightBufferCode, multipassCode, tileCode } from '../techniques/techniqueCode';

/** Shadow maps, cookies, photometric profiles and light layers. */
export const shadowCode = new Lazy('shadows', () => import('../shadows'), 'three draws shadows');

/** Area lights: rectangles, discs and tubes. */
export const areaCode = new Lazy('area-lights', () => import('../lighting/area-lights'), 'three draws rectangles');

/** The views of surfaces, overdraw and buffers. */
export const viewCode = new Lazy('views', () => import('../views'), 'the final picture is shown');

/** Lights as data (LightField); they need the code of tile lists too. */
export const lightFieldCode = new Lazy(
  'light-fields',
  async () => (await Promise.all([import('../light-fields/makeLightFields'), tileCode.load()]))[0],
  'LightFields give no light',
);
lightFieldMade.tell = () => lightFieldCode.ask();

/** Gouraud shading: lights computed at the vertices. */
export const gouraudCode = new Lazy('gouraud', () => import('../materials/gouraud'), 'Gouraud shading is as Phong');

/** Node materials (TSL). */
export const nodeCode = new Lazy('nodes', () => import('../three/nodes/NodeDraws'), 'three draws scenes with nodes');

/** Rules of 'auto', compilation of programs ahead, and `FarolRenderer.ready`. */
export const warmUpCode = new Lazy('warm-up', () => import('./warm-up'), "'auto' has only two techniques");

/** Anti-aliasing of techniques that draw one sample a pixel. */
export const antialiasingCode = new Lazy(
  'antialiasing',
  () => import('../effects/antialiasing/SmoothEdges'),
  'edges are not smooth',
);

/** Code that measures GPU times of passes. */
export const timerCode = new Lazy('timer', () => import('./timer'), 'GPU times are unknown');

/** Scaled frames and the controller that holds a frame budget. */
export const budgetCode = new Lazy('budget', () => import('./budget'), 'frames are drawn at full size');

/** Trials of techniques, which 'auto' learns from. */
export const learningCode = new Lazy('learning', () => import('./learning'), "'auto' uses only its rules");

/** Forgets what 'auto' learnt on the GPUs of this browser, see `FarolOptions.learning`. @throws Error when its code cannot be fetched */
export const clearLearnt = (): Promise<void> => learningCode.load().then((code) => code.clearLearnt());

/** Verdicts that 'auto' learnt on the GPUs of this browser, see `FarolOptions.learning`. @throws Error when its code cannot be fetched */
export const learntChoices = (): Promise<LearntChoice[]> => learningCode.load().then((code) => code.learntChoices());

/** Code that draws frames of XR sessions. */
export const xrCode = new Lazy(
  'webxr',
  async () => (await Promise.all([import('./xr'), arrayCode.load()]))[0],
  'three draws XR sessions',
);

/** Every piece of late code above. */
export const lazyCode = [
  shadowCode,
  areaCode,
  viewCode,
  lightBufferCode,
  multipassCode,
  gridCode,
  tileCode,
  lightFieldCode,
  gouraudCode,
  nodeCode,
  antialiasingCode,
  timerCode,
  budgetCode,
  warmUpCode,
  learningCode,
  arrayCode,
  xrCode,
] as const;

/** Name of a part of the renderer's code that is fetched when a scene or setting first needs it. */
export type LazyPart = (typeof lazyCode)[number]['name'];

/** @throws Error when there is no such part */
export function loadPart(name: LazyPart): Promise<unknown> {
  const code = lazyCode.find((each) => each.name === name);
  if (code !== undefined) return code.load();
  throw unknownName(
    'part',
    name,
    lazyCode.map((each) => each.name),
  );
}
