import { Lazy } from './Lazy';

/** Shadow maps, cookies and light layers. */
export const shadowCode = new Lazy(() => import('../lazy/shadows'), 'shadow maps', 'three draws shadows');

/** The views of surfaces and overdraw. */
export const viewCode = new Lazy(() => import('../lazy/views'), 'this view', 'the final picture is shown');

/** Light pre-pass and inferred lighting. */
export const lightBufferCode = new Lazy(
  () => import('../lazy/light-buffer'),
  'light pre-pass and inferred lighting',
  'deferred shading draws',
);

/** Compiles the programs of a technique ahead, before 'auto' draws by it. */
export const warmUpCode = new Lazy(
  () => import('../lazy/warm-up'),
  'the warm-up of programs',
  "what 'auto' picks is compiled when it is first drawn",
);

/** Times of passes on the GPU. */
export const timerCode = new Lazy(() => import('../lazy/timer'), 'GPU times', 'there are none');

/** All of the above. */
export const lazyCode = [shadowCode, viewCode, lightBufferCode, timerCode, warmUpCode] as const;

/** Those with microshaders of their own, by who brings them. */
export const lazyShaders = { shadows: shadowCode, views: viewCode, 'light-buffer': lightBufferCode } as const;
