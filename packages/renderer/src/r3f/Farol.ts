import { useFrame, useThree } from '@react-three/fiber';
import { type Ref, useImperativeHandle, useLayoutEffect, useState } from 'react';
import type { FarolEffect } from '../FarolEffect';
import type { FarolOptions } from '../FarolOptions';
import { FarolRenderer } from '../FarolRenderer';

const NO_EFFECTS: readonly FarolEffect[] = [];

/** `effects` is a list that stays the same from render to render (`useMemo`); its effects are freed with the component. */
export interface FarolProps extends FarolOptions {
  /**
   * Place of the draw among the `useFrame` callbacks: above 0, and above that of callbacks that move things. R3F does not
   * draw by itself while there is such a callback. Default 1.
   */
  priority?: number;
  /** False: Farol frees what it holds, and R3F draws. Default true. */
  enabled?: boolean;
  /** Gets the FarolRenderer, for `info`, `microshaders` and what else it offers; null while not enabled. */
  ref?: Ref<FarolRenderer | null>;
}

/**
 * Draws the scene of a React Three Fiber canvas (or portal) by Farol, in place of R3F's own draw. `technique`, `view`,
 * `timing`, `effects` and `lightLayers` may change at any time. With `frameloop="demand"` a change of them asks for a frame.
 *
 * @example
 * <Canvas>
 *   <Farol technique="clustered-deferred" />
 *   <mesh>…</mesh>
 * </Canvas>
 *
 * @throws Error as FarolRenderer does, for an unknown technique or a device that cannot run it
 * @throws RangeError when the priority is not above 0
 * @see https://r3f.docs.pmnd.rs/api/hooks#useframe
 */
export function Farol(props: FarolProps): null {
  const { technique = 'auto', view = 'final', timing = false, effects = NO_EFFECTS, shadowAtlasSize } = props;
  const { lightLayers = false, priority = 1, enabled = true, ref } = props;
  if (!(priority > 0)) throw new RangeError(`<Farol priority={${priority}}>: give a number above 0; R3F draws else.`);
  const webgl = useThree((state) => state.gl);
  const invalidate = useThree((state) => state.invalidate);
  const [farol, setFarol] = useState<FarolRenderer | null>(null);

  // Layout effects, and what they set, are done before the next frame: it never sees a Farol that was disposed.
  useLayoutEffect(() => {
    if (!enabled) return;
    const made = new FarolRenderer(webgl, { shadowAtlasSize });
    // oxlint-disable-next-line react/set-state-in-effect -- it holds GPU resources, which a render that React drops would leak
    setFarol(made);
    return () => {
      setFarol(null);
      made.dispose();
      invalidate();
    };
  }, [webgl, enabled, shadowAtlasSize, invalidate]);

  useLayoutEffect(() => {
    if (!farol) return;
    farol.technique = technique;
    farol.view = view;
    farol.timing = timing;
    farol.effects = effects;
    farol.lightLayers = lightLayers;
    invalidate();
  }, [farol, technique, view, timing, effects, lightLayers, invalidate]);

  useImperativeHandle<FarolRenderer | null, FarolRenderer | null>(ref, () => farol, [farol]);

  useFrame(({ scene, camera }) => farol?.render(scene, camera), enabled ? priority : 0);
  return null;
}
