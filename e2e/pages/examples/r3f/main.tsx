/** React Three Fiber, drawn by Farol. */
import type { FarolRenderer, TechniqueName } from '@farol/renderer';
import { SMAA } from '@farol/renderer/antialiasing';
import { Farol } from '@farol/renderer/r3f';
import { advance, Canvas, useFrame } from '@react-three/fiber';
import { use, useMemo, useRef, useState } from 'react';
import type { Mesh, Scene, WebGLRenderer } from 'three';
import { askedDrawer, type Drawer, readCanvas } from '../shared/examplePage';
import { DrawerSelect, LitFloor, showPage, until } from '../shared/reactParts';

const address = new URLSearchParams(location.search);
const still = address.has('still');
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
        <DrawerSelect by={by} onChange={setBy} />
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
        <LitFloor hasLayers={hasLayers} />
        <Knot />
        <Sibling loads={loads} />
      </Canvas>
    </>
  );
}

showPage(App);

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
