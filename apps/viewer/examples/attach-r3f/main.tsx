/** Opens Farol's editor over a React Three Fiber page. */
import '../shared/example.css';
import { type AttachedEditor, attachEditor } from '@farol/attach';
import { Farol } from '@farol/renderer/r3f';
import { advance, Canvas, useFrame, useThree } from '@react-three/fiber';
import { StrictMode, useEffect, useRef, useState } from 'react';
import { createRoot } from 'react-dom/client';
import type { Camera, Group, Scene, WebGLRenderer } from 'three';
import { readCanvas } from '../shared/examplePage';

const address = new URLSearchParams(location.search);
const still = address.has('still');
const hues = Array.from({ length: 24 }, (_, i) => i * 15);

/** Interface for the browser tests. */
let page: { editor: AttachedEditor; scene: Scene; camera: Camera; webgl: WebGLRenderer } | null = null;

/** Opens the editor over the `<Canvas>` around it. */
function Editor() {
  const { scene, camera, gl, invalidate } = useThree();
  useEffect(() => {
    const editor = attachEditor(scene, camera, gl, { onChange: () => (still ? advance(1) : invalidate()) });
    page = { editor, scene, camera, webgl: gl };
    return () => editor.dispose();
  }, [scene, camera, gl, invalidate]);
  return null;
}

function Lanterns() {
  const group = useRef<Group>(null);
  useFrame(({ clock }) => group.current?.rotation.set(0, 0.2 * clock.elapsedTime, 0));
  return (
    <group ref={group} name="lanterns">
      {hues.map((hue, i) => (
        <pointLight
          key={hue}
          name={`lantern ${i + 1}`}
          color={`hsl(${hue}, 70%, 60%)`}
          intensity={6}
          distance={5}
          position={[(2 + (i % 3)) * Math.cos(i), 0.6 + (i % 4) / 2, (2 + (i % 3)) * Math.sin(i)]}
        />
      ))}
    </group>
  );
}

function App() {
  const [count, setCount] = useState(1);
  return (
    <>
      <nav>
        <a href="../index.html">Examples</a>
        <button type="button" onClick={() => setCount(count + 1)}>
          Add a ball
        </button>
      </nav>
      <Canvas
        dpr={1}
        gl={{ antialias: false }}
        camera={{ position: [0, 3.4, 8.5], fov: 50 }}
        frameloop={still ? 'never' : 'always'}
        onCreated={({ camera }) => camera.lookAt(0, 1.4, 0)}
      >
        <Editor />
        {address.has('farol') && <Farol technique="deferred" />}
        <color attach="background" args={['#10141c']} />
        <hemisphereLight args={['#8fa8d8', '#40342a', 0.35]} />
        <mesh name="floor" rotation-x={-Math.PI / 2}>
          <planeGeometry args={[24, 24]} />
          <meshStandardMaterial color="#9a9488" roughness={0.75} />
        </mesh>
        {Array.from({ length: count }, (_, i) => (
          <mesh key={i} name={`ball ${i + 1}`} position={[-1.6 * i, 1, 0]}>
            <sphereGeometry args={[0.7, 32, 24]} />
            <meshStandardMaterial color="#c98f5a" metalness={0.5} roughness={0.4} />
          </mesh>
        ))}
        <Lanterns />
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

window.example = {
  ready: until(() => page !== null),
  get editor() {
    return page!.editor;
  },
  get scene() {
    return page!.scene;
  },
  get camera() {
    return page!.camera;
  },
  get farol() {
    return page!.editor.farol!;
  },
  get webgl() {
    return page!.webgl;
  },
  async draw(by) {
    await page!.editor.drawWith(by);
    advance(1);
    return readCanvas(page!.webgl);
  },
};
