import { Farol } from '@farol/renderer/r3f';
import { Canvas, useFrame } from '@react-three/fiber';
import { lamps, moveLamps } from './lamps';

const columns = Array.from({ length: 12 }, (_, i) => ((i + 0.5) / 6) * Math.PI);

/** 200 moving lamps; lights written as `<pointLight>` elements work as well. */
function Lamps() {
  useFrame(({ clock }) => moveLamps(clock.elapsedTime));
  return <primitive object={lamps} />;
}

export const App = () => (
  <Canvas camera={{ position: [0, 4, 12], fov: 50 }}>
    <Farol />
    <ambientLight intensity={0.1} />
    <Lamps />
    <mesh rotation-x={-Math.PI / 2}>
      <planeGeometry args={[60, 60]} />
      <meshStandardMaterial color="gray" roughness={0.5} />
    </mesh>
    <mesh position-y={1.8}>
      <torusKnotGeometry args={[1, 0.3, 200, 32]} />
      <meshStandardMaterial color="gold" roughness={0.3} metalness={0.6} />
    </mesh>
    {columns.map((angle) => (
      <mesh key={angle} position={[7 * Math.cos(angle), 1.5, 7 * Math.sin(angle)]}>
        <boxGeometry args={[0.6, 3, 0.6]} />
        <meshStandardMaterial color="gray" roughness={0.5} />
      </mesh>
    ))}
  </Canvas>
);
