/** Opens Farol's editor over a React Three Fiber page. */
import { type AttachedEditor, attachEditor } from '@farol/attach';
import { Farol } from '@farol/renderer/r3f';
import { advance, Canvas, useThree } from '@react-three/fiber';
import { useEffect, useState } from 'react';
import type { Camera, Scene, WebGLRenderer } from 'three';
import { readCanvas } from '../shared/examplePage';
import { LitFloor, showPage, until } from '../shared/reactParts';

const address = new URLSearchParams(location.search);
const still = address.has('still');

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

function App() {
  const [count, setCount] = useState(1);
  return (
    <>
      <nav>
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
        <LitFloor />
        {Array.from({ length: count }, (_, i) => (
          <mesh key={i} name={`ball ${i + 1}`} position={[-1.6 * i, 1, 0]}>
            <sphereGeometry args={[0.7, 32, 24]} />
            <meshStandardMaterial color="#c98f5a" metalness={0.5} roughness={0.4} />
          </mesh>
        ))}
      </Canvas>
    </>
  );
}

showPage(App);

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
