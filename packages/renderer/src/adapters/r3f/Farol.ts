import { useThree } from '@react-three/fiber';
import type { Scene } from 'three';
import { type FarolProps, useFarolSettings } from './useFarolSettings';

/**
 * While it is mounted, what a React Three Fiber canvas draws by `gl.render` is drawn by Farol: R3F's own frame, and what
 * components draw (views, portals, render textures, mirrors, composers). Inside a portal, such as drei's `<View>`, it is
 * for the scene of that portal alone. One FarolRenderer serves a canvas.
 *
 * @example
 * <Canvas>
 *   <Farol technique="clustered-deferred" />
 *   <mesh>…</mesh>
 * </Canvas>
 *
 * @throws Error as FarolRenderer does, for an unknown technique or a device that cannot run it
 */
export function Farol(props: FarolProps): null {
  const scene = useThree((state) => (state.previousRoot && (state.scene as Scene).isScene ? state.scene : null));
  useFarolSettings(props, scene);
  return null;
}
