/** drei and @react-three/postprocessing, drawn by Farol: components that draw by themselves, such as views, portals and gizmos. */
import type { FarolRenderer } from '@farol/renderer';
import { Farol, type FarolProps } from '@farol/renderer/r3f';
import { advance, Canvas } from '@react-three/fiber';
import { useState } from 'react';
import type { WebGLRenderer } from 'three';
import { askedDrawer, type Drawer, readCanvas } from '../shared/examplePage';
import { DrawerSelect, showPage, until } from '../shared/reactParts';
import { parts, partsWithFarol } from './parts';

const address = new URLSearchParams(location.search);
const still = address.has('still');
const names = [...Object.keys(parts), ...Object.keys(partsWithFarol)];

/** Interface for the browser tests. */
const page: {
  choose(by: Drawer): void;
  show(part: string): void;
  part: string;
  settled: boolean;
  farol: FarolRenderer | null;
  webgl: WebGLRenderer | null;
} = { choose: () => {}, show: () => {}, part: '', settled: false, farol: null, webgl: null };

function App() {
  const [by, setBy] = useState<Drawer>(askedDrawer);
  const asked = address.get('part');
  const [part, setPart] = useState(asked !== null && names.includes(asked) ? asked : 'View');
  Object.assign(page, { choose: setBy, show: setPart, part });
  const farol: FarolProps = {
    enabled: by !== 'three',
    technique: by === 'three' ? 'auto' : by,
    ref: (farol) => {
      page.farol = farol;
    },
  };
  const Part = parts[part];
  const PartWithFarol = partsWithFarol[part];
  return (
    <>
      <nav>
        <DrawerSelect by={by} onChange={setBy} />
        <select aria-label="Component" value={part} onChange={({ target }) => setPart(target.value)}>
          {names.map((name) => (
            <option key={name}>{name}</option>
          ))}
        </select>
      </nav>
      <Canvas
        dpr={1}
        shadows="percentage"
        gl={{ antialias: address.has('antialias') }}
        camera={{ position: [0, 3.4, 8.5], fov: 50 }}
        frameloop={still ? 'never' : 'always'}
        onCreated={({ gl, camera }) => {
          page.webgl = gl;
          camera.lookAt(0, 1.4, 0);
        }}
      >
        {PartWithFarol ? <PartWithFarol key={part} farol={farol} /> : <Farol {...farol} />}
        {Part && <Part key={part} />}
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
  parts: names,
  async show(part) {
    page.settled = false;
    page.show(part);
    await until(() => page.part === part);
  },
  async draw(by) {
    page.choose(by);
    await until(() => chosen(by));
    // components of drei take some frames to settle
    for (let i = page.settled ? 1 : 6; i > 0; i--) {
      advance(1);
      await new Promise(requestAnimationFrame);
    }
    page.settled = true;
    advance(1);
    return readCanvas(page.webgl!);
  },
};
