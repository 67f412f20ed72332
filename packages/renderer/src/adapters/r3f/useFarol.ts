import { useThree } from '@react-three/fiber';
import { useSyncExternalStore } from 'react';
import type { FarolRenderer } from '../../renderer/FarolRenderer';
import { CanvasFarol } from './CanvasFarol';

/**
 * The FarolRenderer of the canvas that the component is in, or null while nothing is drawn by Farol. The component is
 * rendered anew when that changes.
 *
 * @example
 * const farol = useFarol();
 * useFrame(() => console.log(farol?.info.drawCalls));
 */
export function useFarol(): FarolRenderer | null {
  const canvas = CanvasFarol.of(useThree((state) => state.gl));
  return useSyncExternalStore(canvas.subscribe, canvas.current);
}
