import { techniques } from '@farol/renderer';
import { useFrame } from '@react-three/fiber';
import { type ComponentType, StrictMode, useRef } from 'react';
import { createRoot } from 'react-dom/client';
import type { Group } from 'three';
import type { Drawer } from './examplePage';

const hues = Array.from({ length: 24 }, (_, i) => i * 15);

/** Menu of techniques. */
export function DrawerSelect({ by, onChange }: { by: Drawer; onChange(by: Drawer): void }) {
  return (
    <select aria-label="Drawn by" value={by} onChange={({ target }) => onChange(target.value as Drawer)}>
      <option value="three">three's own renderer</option>
      {Object.entries(techniques).map(([name, { label }]) => (
        <option key={name} value={name}>
          Farol: {label}
        </option>
      ))}
    </select>
  );
}

/** A floor under 24 lights that go round. @param hasLayers - puts every other light on layer 1 */
export function LitFloor({ hasLayers = false }: { hasLayers?: boolean }) {
  const group = useRef<Group>(null);
  useFrame(({ clock }) => group.current?.rotation.set(0, 0.2 * clock.elapsedTime, 0));
  return (
    <>
      <color attach="background" args={['#10141c']} />
      <hemisphereLight args={['#8fa8d8', '#40342a', 0.35]} />
      <mesh name="floor" rotation-x={-Math.PI / 2}>
        <planeGeometry args={[24, 24]} />
        <meshStandardMaterial color="#9a9488" roughness={0.75} />
      </mesh>
      <group ref={group} name="lanterns">
        {hues.map((hue, i) => (
          <pointLight
            key={hue}
            name={`lantern ${i + 1}`}
            color={`hsl(${hue}, 70%, 60%)`}
            intensity={6}
            distance={5}
            layers={hasLayers ? i % 2 : 0}
            position={[(2 + (i % 3)) * Math.cos(i), 0.6 + (i % 4) / 2, (2 + (i % 3)) * Math.sin(i)]}
          />
        ))}
      </group>
    </>
  );
}

/** Shows a component as the page. */
export function showPage(App: ComponentType): void {
  createRoot(document.querySelector('#root')!).render(
    <StrictMode>
      <App />
    </StrictMode>,
  );
}

/** Waits, frame by frame, until a condition holds. */
export async function until(holds: () => boolean): Promise<void> {
  while (!holds()) await new Promise(requestAnimationFrame);
}
