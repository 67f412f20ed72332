import { lightFieldMade } from '../light-field/lightFieldMade';
import { Lazy } from './Lazy';

/** Shadow maps, cookies, photometric profiles and light layers. */
export const shadowCode = new Lazy('shadows', () => import('../lazy/shadows'), 'three draws shadows');

/** Area lights: rectangles, discs and tubes. */
export const areaCode = new Lazy('area-lights', () => import('../lazy/area-lights'), 'three draws rectangles');

/** The views of surfaces and overdraw. */
export const viewCode = new Lazy('views', () => import('../lazy/views'), 'the final picture is shown');

/** Light pre-pass and inferred lighting. */
export const lightBufferCode = new Lazy('light-buffer', () => import('../lazy/light-buffer'), 'deferred shading draws');

/** Light lists of clusters: clustered forward and clustered deferred shading. */
export const gridCode = new Lazy('light-grid', () => import('../lazy/light-grid'), 'other techniques draw');

/** Light lists of tiles: Forward+, tiled forward and tiled deferred shading. */
export const tileCode = new Lazy('light-tiles', () => import('../lazy/light-tiles'), 'other techniques draw');

/** Multipass lighting: the technique 'forward'. */
export const multipassCode = new Lazy('multipass', () => import('../lazy/multipass'), 'deferred shading draws');

/** Lights as data: LightField. Their lists are those of tiles. */
export const lightFieldCode = new Lazy(
  'light-fields',
  async () => (await Promise.all([import('../lazy/light-fields'), tileCode.load()]))[0],
  'their lights light nothing',
);
lightFieldMade.tell = () => lightFieldCode.ask();

/** Lights at the vertices. */
export const gouraudCode = new Lazy('gouraud', () => import('../lazy/gouraud'), 'light is in pixels');

/** Node materials (TSL). */
export const nodeCode = new Lazy('nodes', () => import('../lazy/nodes'), 'three draws scenes that have some');

/** Compiles programs ahead, and waits for a picture that is as it stays. */
export const warmUpCode = new Lazy(
  'warm-up',
  () => import('../lazy/warm-up'),
  "what 'auto' picks is compiled when it is first drawn",
);

/** Anti-aliasing of techniques that draw one sample a pixel. */
export const antialiasingCode = new Lazy('antialiasing', () => import('../lazy/antialiasing'), 'edges are not smooth');

/** Times of passes on the GPU. */
export const timerCode = new Lazy('timer', () => import('../lazy/timer'), 'there are none');

/** All of the above. */
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
  warmUpCode,
] as const;

/** Name of a part of the renderer's code that is fetched when a scene or setting first needs it. */
export type LazyPart = (typeof lazyCode)[number]['name'];
