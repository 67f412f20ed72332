import { Lazy } from './Lazy';

/** Shadow maps, cookies, photometric profiles and light layers. */
export const shadowCode = new Lazy(() => import('../lazy/shadows'), 'shadow maps', 'three draws shadows');

/** Area lights: rectangles, discs and tubes. */
export const areaCode = new Lazy(() => import('../lazy/area-lights'), 'area lights', 'three draws rectangles');

/** The views of surfaces and overdraw. */
export const viewCode = new Lazy(() => import('../lazy/views'), 'this view', 'the final picture is shown');

/** Light pre-pass and inferred lighting. */
export const lightBufferCode = new Lazy(
  () => import('../lazy/light-buffer'),
  'light pre-pass and inferred lighting',
  'deferred shading draws',
);

/** Multipass lighting: the technique 'forward'. */
export const multipassCode = new Lazy(
  () => import('../lazy/multipass'),
  'multipass lighting',
  'deferred shading draws',
);

/** Lights as data: LightField. */
export const lightFieldCode = new Lazy(
  () => import('../lazy/light-fields'),
  'light fields',
  'their lights light nothing',
);

/** Lights at the vertices. */
export const gouraudCode = new Lazy(() => import('../lazy/gouraud'), 'Gouraud shading', 'light is in pixels');

/** Node materials (TSL). */
export const nodeCode = new Lazy(() => import('../lazy/nodes'), 'node materials', 'three draws scenes that have some');

/** Compiles the programs of a technique ahead, before 'auto' draws by it. */
export const warmUpCode = new Lazy(
  () => import('../lazy/warm-up'),
  'the warm-up of programs',
  "what 'auto' picks is compiled when it is first drawn",
);

/** Times of passes on the GPU. */
export const timerCode = new Lazy(() => import('../lazy/timer'), 'GPU times', 'there are none');

/** All of the above. */
export const lazyCode = [
  shadowCode,
  areaCode,
  viewCode,
  lightBufferCode,
  multipassCode,
  lightFieldCode,
  gouraudCode,
  nodeCode,
  timerCode,
  warmUpCode,
] as const;

/** Those with microshaders of their own, by who brings them. */
export const lazyShaders = {
  shadows: shadowCode,
  'area-lights': areaCode,
  views: viewCode,
  'light-buffer': lightBufferCode,
  multipass: multipassCode,
  'light-fields': lightFieldCode,
  gouraud: gouraudCode,
} as const;
