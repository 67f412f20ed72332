import { LateCode } from './LateCode';

export { LateCode };

/** Shadow maps, cookies and light layers. */
export const shadowCode = new LateCode(() => import('../lazy/shadows'), 'shadow maps', 'three draws shadows');

/** The views of surfaces and overdraw. */
export const viewCode = new LateCode(() => import('../lazy/views'), 'this view', 'the final picture is shown');

/** Light pre-pass and inferred lighting. */
export const lightBufferCode = new LateCode(
  () => import('../lazy/light-buffer'),
  'light pre-pass and inferred lighting',
  'deferred shading draws',
);

/** What has a technique ready before 'auto' draws by it. */
export const rehearsalCode = new LateCode(
  () => import('../lazy/warm-up/Rehearsal'),
  'rehearsals',
  "what 'auto' picks is compiled when it is first drawn",
);

/** Times of passes on the GPU. */
export const timerCode = new LateCode(() => import('../lazy/timer/GpuTimer'), 'GPU times', 'there are none');
