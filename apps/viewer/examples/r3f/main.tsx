/** React Three Fiber, drawn by Farol. */
import { type FarolRenderer, type TechniqueName, techniques } from '@farol/renderer';
import { SMAA } from '@farol/renderer/antialiasing';
import { Farol } from '@farol/renderer/r3f';
import { advance, Canvas, useFrame } from '@react-three/fiber';
import { StrictMode, use, useMemo, useRef, useState } from 'react';
import { createRoot } from 'react-dom/client';
import type { Group, Mesh, Scene, WebGLRenderer } from 'three';
import { askedDrawer, type Drawer, readCanvas } from '../shared/examplePage';

const address = new URLSearchParams(location.search);
const still = address.has('still');
const hues = Array.from({ length: 24 }, (_, i) => i * 15);
/** With `?layers` every other lantern is on layer 1, which has no objects. */
const hasLayers = address.has('layers');

/** Interface for the browser tests. */
const page: {
  choose(by: Drawer): void;
  suspend(promise: Promise<unknown>): void;
  farol: FarolRenderer | null;
  webgl: WebGLRenderer | null;
  scene: Scene | null;
} = { choose: () => {}, suspend: () => {}, farol: null, webgl: null, scene: null };
const made = new Set<FarolRenderer>();

/** Component that suspends until a promise is fulfilled. */
function Sibling({ loads }: { loads: Promise<unknown> | null }) {
  if (loads) use(loads);
  return null;
}

function Lanterns() {
  const group = useRef<Group>(null);
  useFrame(({ clock }) => group.current?.rotation.set(0, 0.2 * clock.elapsedTime, 0));
  return (
    <group ref={group}>
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
  );
}

function Knot() {
  const knot = useRef<Mesh>(null);
  useFrame(({ clock }) => knot.current?.rotation.set(0.3 * clock.elapsedTime, 0.5 * clock.elapsedTime, 0));
  return (
    <mesh ref={knot} name="knot" position-y={1.7}>
      <torusKnotGeometry args={[0.8, 0.26, 120, 20]} />
      <meshStandardMaterial color="#c98f5a" metalness={0.6} roughness={0.35} />
    </mesh>
  );
}

function App() {
  const [by, setBy] = useState<Drawer>(askedDrawer);
  const [smooth, setSmooth] = useState(false);
  const effects = useMemo(() => (smooth ? [new SMAA()] : []), [smooth]);
  const [loads, suspend] = useState<Promise<unknown> | null>(null);
  Object.assign(page, { choose: setBy, suspend });
  return (
    <>
      <nav>
        <a href="../index.html">Examples</a>
        <select aria-label="Drawn by" value={by} onChange={({ target }) => setBy(target.value as Drawer)}>
          <option value="three">three's own renderer</option>
          {Object.entries(techniques).map(([name, { label }]) => (
            <option key={name} value={name}>
              Farol: {label}
            </option>
          ))}
        </select>
        <label>
          <input type="checkbox" checked={smooth} onChange={({ target }) => setSmooth(target.checked)} /> SMAA
        </label>
      </nav>
      <Canvas
        dpr={1}
        gl={{ antialias: address.has('antialias') }}
        camera={{ position: [0, 3.4, 8.5], fov: 50 }}
        frameloop={still ? 'never' : 'always'}
        onCreated={({ gl, scene, camera }) => {
          Object.assign(page, { webgl: gl, scene });
          if (hasLayers) camera.layers.enableAll();
          camera.lookAt(0, 1.4, 0);
        }}
      >
        <Farol
          enabled={by !== 'three'}
          effects={effects}
          technique={by === 'three' ? 'auto' : (by satisfies TechniqueName)}
          lightLayers={hasLayers}
          ref={(farol) => {
            page.farol = farol;
            if (farol) made.add(farol);
          }}
        />
        <color attach="background" args={['#10141c']} />
        <hemisphereLight args={['#8fa8d8', '#40342a', 0.35]} />
        <mesh name="floor" rotation-x={-Math.PI / 2}>
          <planeGeometry args={[24, 24]} />
          <meshStandardMaterial color="#9a9488" roughness={0.75} />
        </mesh>
        <Knot />
        <Lanterns />
        <Sibling loads={loads} />
      </Canvas>
    </>
  );
}

createRoot(document.querySelector('#root')!).render(
  <StrictMode>
    <App />
  </StrictMode>,
);

/** Waits, frame by frame, until a condition holds. */
async function until(holds: () => boolean): Promise<void> {
  while (!holds()) await new Promise(requestAnimationFrame);
}

const chosen = (by: Drawer) => (by === 'three' ? page.farol === null : page.farol?.technique === by);
window.example = {
  ready: until(() => page.webgl !== null && (page.farol !== null || askedDrawer() === 'three')),
  get farol() {
    return page.farol!;
  },
  get webgl() {
    return page.webgl!;
  },
  get scene() {
    return page.scene!;
  },
  get made() {
    return made.size;
  },
  suspend: (promise) => page.suspend(promise),
  async draw(by) {
    page.choose(by);
    await until(() => chosen(by));
    advance(1);
    return readCanvas(page.webgl!);
  },
};
