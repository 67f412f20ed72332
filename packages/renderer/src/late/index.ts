import { LateCode } from './LateCode';

export { LateCode };

/** Shadow maps, cookies and light layers. */
export const shadowCode = new LateCode(() => import('../shadows'), 'no code of shadow maps; three draws them');

/** The views of surfaces and overdraw. */
export const viewCode = new LateCode(() => import('../debug'), 'no code of this view; the final picture is shown');

/** Light pre-pass and inferred lighting. */
export const lightBufferCode = new LateCode(
  () => import('../light-buffer'),
  'no code of light pre-pass and inferred lighting; deferred shading draws',
);

/** What has a technique ready before 'auto' draws by it. */
export const rehearsalCode = new LateCode(
  () => import('../rehearsal/Rehearsal'),
  "no code of rehearsals; what 'auto' picks is compiled when it is first drawn",
);

/** Times of passes on the GPU. */
export const timerCode = new LateCode(() => import('../GpuTimer'), 'no code of GPU times; there are none');
