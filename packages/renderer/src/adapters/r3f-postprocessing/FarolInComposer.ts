import { EffectComposerContext } from '@react-three/postprocessing';
import { use } from 'react';
import { type FarolProps, useFarolSettings } from '../r3f/useFarolSettings';

/**
 * Inside the `<EffectComposer>` of @react-three/postprocessing, has the scene of that composer drawn by Farol, in the place
 * where it is drawn anyway: nothing is drawn twice. Where `<Farol>` is mounted it is not needed; its props then count for
 * the composer's scene.
 *
 * @example
 * <EffectComposer>
 *   <FarolInComposer technique="clustered-deferred" />
 *   <Bloom />
 * </EffectComposer>
 *
 * @throws Error outside of an EffectComposer, and as FarolRenderer does
 */
export function FarolInComposer(props: FarolProps): null {
  const composer = use(EffectComposerContext);
  if (!composer)
    throw new Error('<FarolInComposer> is outside of an <EffectComposer>: put it into one, or use <Farol>.');
  useFarolSettings(props, composer.scene);
  return null;
}
