import { EffectComposerContext } from '@react-three/postprocessing';
import { use } from 'react';
import { type FarolProps, useFarolSettings } from '../r3f/useFarolSettings';

/**
 * Inside the `<EffectComposer>` of @react-three/postprocessing, Farol draws that composer's scene in place of three;
 * nothing is drawn twice. Not needed inside of `<Farol>`; its props then apply to the composer's scene.
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
