import { useThree } from '@react-three/fiber';
import type { Scene } from 'three';
import { type FarolProps, useFarolSettings } from './useFarolSettings';

/**
 * While mounted, Farol draws whatever a React Three Fiber canvas draws by `gl.render`: R3F's own frames, and those of
 * components (views, portals, render textures, mirrors, composers). Inside a portal, such as drei's `<View>`, only the
 * portal's scene. Each canvas has one FarolRenderer.
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
