import { useThree } from '@react-three/fiber';
import { useSyncExternalStore } from 'react';
import type { FarolRenderer } from '../../renderer/FarolRenderer';
import { CanvasFarol } from './CanvasFarol';

/**
 * The FarolRenderer of the component's canvas; null while Farol draws nothing. Changes re-render the component.
 *
 * @example
 * const farol = useFarol();
 * useFrame(() => console.log(farol?.info.drawCalls));
 */
export function useFarol(): FarolRenderer | null {
  const canvas = CanvasFarol.of(useThree((state) => state.gl));
  return useSyncExternalStore(canvas.subscribe, canvas.current);
}
