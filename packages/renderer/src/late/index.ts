import { LateCode } from './LateCode';

export { LateCode };

/** Shadow maps, cookies and light layers. */
export const shadowCode = new LateCode(() => import('../shadows'), 'shadow maps', 'three draws shadows');

/** The views of surfaces and overdraw. */
export const viewCode = new LateCode(() => import('../debug'), 'this view', 'the final picture is shown');

/** Light pre-pass and inferred lighting. */
export const lightBufferCode = new LateCode(
  () => import('../light-buffer'),
  'light pre-pass and inferred lighting',
  'deferred shading draws',
);

/** What has a technique ready before 'auto' draws by it. */
export const rehearsalCode = new LateCode(
  () => import('../rehearsal/Rehearsal'),
  'rehearsals',
  "what 'auto' picks is compiled when it is first drawn",
);

/** Times of passes on the GPU. */
export const timerCode = new LateCode(() => import('../GpuTimer'), 'GPU times', 'there are none');
