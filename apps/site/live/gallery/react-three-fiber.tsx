/**
 * React Three Fiber
 *
 * `<Farol />` inside `<Canvas>`: components add and take away lamps while it runs, and nothing compiles.
 *
 * @tags react, many lights
 */
import type { FarolRenderer, TechniqueName } from '@farol/renderer';
import { techniques } from '@farol/renderer';
import { Farol } from '@farol/renderer/r3f';
import { Canvas, useFrame } from '@react-three/fiber';
import { useRef, useState } from 'react';
import { createRoot } from 'react-dom/client';
import type { Camera, Group, Scene, WebGLRenderer } from 'three';

function Lamp({ index }: { index: number }) {
  const lamp = useRef<Group>(null);
  const color = `hsl(${(index * 47) % 360}, 85%, 60%)`;
  useFrame(({ clock }) => {
    const angle = 0.3 * clock.elapsedTime * (index % 2 ? 1 : -1) + 2.4 * index;
    const radius = 0.5 * Math.sqrt(index + 1) + 0.6;
    lamp.current!.position.set(radius * Math.cos(angle), 0.4 + 0.35 * (index % 6), radius * Math.sin(angle));
  });
  return (
    <group ref={lamp}>
      <pointLight color={color} intensity={3.2} distance={3.4} />
      <mesh>
        <sphereGeometry args={[0.06, 16, 12]} />
        <meshBasicMaterial color={color} />
      </mesh>
    </group>
  );
}

function Tower({ level }: { level: number }) {
  return (
    <mesh position-y={0.3 + 0.42 * level} rotation-y={0.35 * level}>
      <boxGeometry args={[1.9 - 0.24 * level, 0.4, 1.9 - 0.24 * level]} />
      <meshStandardMaterial color="#e4ddd2" roughness={0.4} metalness={0.1} />
    </mesh>
  );
}

let found!: (handle: { webgl: WebGLRenderer; scene: Scene; camera: Camera }) => void;
const handle = new Promise<{ webgl: WebGLRenderer; scene: Scene; camera: Camera }>((resolve) => (found = resolve));
let drawn!: (farol: FarolRenderer) => void;
const farol = new Promise<FarolRenderer>((resolve) => (drawn = resolve));

function Page() {
  const [count, setCount] = useState(40);
  const [technique, setTechnique] = useState<TechniqueName>('auto');
  return (
    <>
      <Canvas
        camera={{ position: [4.4, 3.2, 6], fov: 42 }}
        onCreated={({ gl, scene, camera }) => {
          camera.lookAt(0, 1, 0);
          found({ webgl: gl, scene, camera });
        }}
      >
        <Farol technique={technique} ref={(each) => void (each && drawn(each))} />
        <color attach="background" args={['#06070b']} />
        <hemisphereLight args={['#8fa8d8', '#302820', 0.25]} />
        <mesh rotation-x={-Math.PI / 2}>
          <planeGeometry args={[40, 40]} />
          <meshStandardMaterial color="#6b6f78" roughness={0.45} />
        </mesh>
        {Array.from({ length: 6 }, (_, level) => (
          <Tower key={level} level={level} />
        ))}
        {Array.from({ length: count }, (_, i) => (
          <Lamp key={i} index={i} />
        ))}
      </Canvas>
      <div className="panel">
        <label>
          Lamps <input type="range" min={1} max={120} value={count} onChange={(e) => setCount(+e.target.value)} />{' '}
          {count}
        </label>
        <select
          aria-label="Technique"
          value={technique}
          onChange={({ target }) => setTechnique(target.value as TechniqueName)}
        >
          {Object.entries(techniques).map(([name, { label }]) => (
            <option key={name} value={name}>
              {label}
            </option>
          ))}
        </select>
      </div>
    </>
  );
}

document.querySelector('canvas')?.remove(); // `<Canvas>` makes a canvas of its own
const root = document.createElement('div');
root.style.cssText = 'width: 100vw; height: 100vh';
document.body.append(root);
createRoot(root).render(<Page />);

const webgl = handle.then((each) => each.webgl);
const scene = handle.then((each) => each.scene);
const camera = handle.then((each) => each.camera);
export { camera, farol, scene, webgl };
