/**
 * drei: a portal and a mirror floor
 *
 * MeshPortalMaterial opens another lit world in an arch, MeshReflectorMaterial mirrors both; Farol draws each of them.
 *
 * @tags react, targets
 */
import type { FarolRenderer } from '@farol/renderer';
import { Farol } from '@farol/renderer/r3f';
import { MeshPortalMaterial, MeshReflectorMaterial, OrbitControls } from '@react-three/drei';
import { Canvas, useFrame } from '@react-three/fiber';
import { useRef } from 'react';
import { createRoot } from 'react-dom/client';
import { type Camera, type Group, type Scene, Shape, type WebGLRenderer } from 'three';

/** Lamps that go round. */
function Lamps({ hue, count }: { hue: number; count: number }) {
  const group = useRef<Group>(null);
  useFrame(({ clock }) => void (group.current!.rotation.y = 0.25 * clock.elapsedTime));
  return (
    <group ref={group}>
      {Array.from({ length: count }, (_, i) => (
        <pointLight
          key={i}
          color={`hsl(${hue + 9 * (i % 5)}, 90%, 60%)`}
          intensity={5}
          distance={4.5}
          position={[3 * Math.cos(2.4 * i), 0.5 + 0.5 * (i % 5), 3 * Math.sin(2.4 * i)]}
        />
      ))}
    </group>
  );
}

const arch = new Shape().moveTo(-1, 0).lineTo(-1, 1.7).absarc(0, 1.7, 1, Math.PI, 0, true).lineTo(1, 0);

let found!: (handle: { webgl: WebGLRenderer; scene: Scene; camera: Camera }) => void;
const handle = new Promise<{ webgl: WebGLRenderer; scene: Scene; camera: Camera }>((resolve) => (found = resolve));
let drawn!: (farol: FarolRenderer) => void;
const farol = new Promise<FarolRenderer>((resolve) => (drawn = resolve));

function Page() {
  return (
    <Canvas
      camera={{ position: [2.2, 1.8, 6.4], fov: 42 }}
      onCreated={({ gl, scene, camera }) => found({ webgl: gl, scene, camera })}
    >
      <Farol technique="clustered-forward" ref={(each) => void (each && drawn(each))} />
      <OrbitControls target={[0, 1.2, 0]} />
      <color attach="background" args={['#06060b']} />
      <hemisphereLight args={['#8fa8d8', '#302820', 0.25]} />
      <Lamps hue={200} count={16} />
      <mesh rotation-x={-Math.PI / 2}>
        <planeGeometry args={[30, 30]} />
        <MeshReflectorMaterial color="#707680" roughness={0.5} resolution={512} mirror={0.7} mixStrength={1.5} />
      </mesh>
      {[-2.3, 2.3].map((x) => (
        <mesh key={x} position={[x, 1.3, -0.4]}>
          <cylinderGeometry args={[0.3, 0.38, 2.6, 32]} />
          <meshStandardMaterial color="#d8d0c4" roughness={0.5} />
        </mesh>
      ))}
      <mesh position={[0, 0.02, 0]}>
        <shapeGeometry args={[arch, 32]} />
        <MeshPortalMaterial blur={0} resolution={512}>
          <color attach="background" args={['#2a0d16']} />
          <hemisphereLight args={['#ffb080', '#401020', 0.4]} />
          <Lamps hue={330} count={16} />
          <mesh position={[0, 1.2, -1.5]}>
            <torusKnotGeometry args={[0.7, 0.24, 160, 24]} />
            <meshStandardMaterial color="#ffd9a0" roughness={0.3} metalness={0.4} />
          </mesh>
          <mesh rotation-x={-Math.PI / 2}>
            <planeGeometry args={[30, 30]} />
            <meshStandardMaterial color="#a04848" roughness={0.6} />
          </mesh>
        </MeshPortalMaterial>
      </mesh>
    </Canvas>
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
