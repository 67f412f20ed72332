import { type FarolOptions, FarolRenderer, type TechniqueName } from '@farol/renderer';
import { webglProblem } from '../stage/deviceLimits';
import type { Competitor, Drawing } from './Competitor';
import { competitorNames } from './competitorNames';
import { createWebGL } from './createWebGL';

/** `auto` is settled after this many frames by one technique: it may change techniques after estimating overdraw. */
const SETTLED = 48;

/** Farol with a technique and a quality as a competitor; the renderer's code is fetched before frames are timed. */
export function farol(technique: TechniqueName, quality: Required<FarolOptions>['quality'] = 'full'): Competitor {
  const name = quality === 'lite' ? 'lite' : technique;
  return {
    name,
    ...competitorNames[name],
    unavailable: async () => webglProblem(),
    refuses: () => null,
    async open(canvas, scene, signal): Promise<Drawing> {
      await FarolRenderer.preload();
      const particles = scene.emitter ? await import('@farol/renderer/particles') : null;
      signal.throwIfAborted();
      const { renderer, gl, check, dispose } = createWebGL(canvas, scene);
      const { three, camera } = scene;
      const drawn = new FarolRenderer(renderer, { technique, quality });
      if (particles) drawn.effects = [new particles.Particles()];
      let last = '';
      let same = 0;
      const isSettled = (): boolean => {
        const { technique } = drawn.info;
        same = technique === last ? same + 1 : 0;
        last = technique;
        return same >= SETTLED;
      };
      return {
        gl,
        ...(technique === 'auto' && { isSettled }),
        render: () => drawn.render(three, camera),
        check,
        technique: () => ({ name: drawn.info.technique, reason: drawn.info.reason }),
        targetBytes: () => drawn.info.targetBytes,
        passes() {
          const { passes } = drawn.info;
          const timed = passes.some(({ gpuMs }) => gpuMs !== null);
          return {
            kind: timed ? 'gpu' : 'cpu',
            passes: passes.map(({ name, gpuMs, cpuMs }) => ({ name, ms: timed ? (gpuMs ?? 0) : cpuMs })),
          };
        },
        setPassTimes: (on) => void (drawn.timing = on),
        leaveTechnique() {
          drawn.technique = drawn.info.technique === 'deferred' ? 'clustered-forward' : 'deferred';
          return () => void (drawn.technique = technique);
        },
        dispose() {
          drawn.dispose();
          dispose();
        },
      };
    },
  };
}
