import {
  AccumulativeShadows,
  ContactShadows,
  CubeCamera,
  Environment,
  GizmoHelper,
  GizmoViewport,
  Hud,
  Lightformer,
  MeshPortalMaterial,
  MeshReflectorMaterial,
  PerspectiveCamera,
  Preload,
  RenderTexture,
  View,
} from '@react-three/drei';
import { Farol, type FarolProps } from '@farol/renderer/r3f';
import { FarolInComposer } from '@farol/renderer/r3f-postprocessing';
import { Bloom, EffectComposer, Vignette } from '@react-three/postprocessing';
import { type ComponentType, memo, type ReactNode, useLayoutEffect, useState } from 'react';

const hues = Array.from({ length: 12 }, (_, i) => i * 30);

/** Twelve lanterns over a floor with objects. */
function Square({ children, floor }: { children?: ReactNode; floor?: ReactNode }) {
  return (
    <>
      <color attach="background" args={['#10141c']} />
      <Lanterns />
      <mesh rotation-x={-Math.PI / 2}>
        <planeGeometry args={[24, 24]} />
        {floor ?? <meshStandardMaterial color="#9a9488" roughness={0.75} />}
      </mesh>
      {children}
    </>
  );
}

function Lanterns() {
  return (
    <>
      <hemisphereLight args={['#8fa8d8', '#40342a', 0.35]} />
      {hues.map((hue, i) => (
        <pointLight
          key={hue}
          color={`hsl(${hue}, 70%, 60%)`}
          intensity={6}
          distance={5}
          position={[(2 + (i % 3)) * Math.cos(i), 0.8 + (i % 4) / 2, (2 + (i % 3)) * Math.sin(i)]}
        />
      ))}
    </>
  );
}

function Knot({ x = 0, color = '#c98f5a' }: { x?: number; color?: string }) {
  return (
    <mesh position={[x, 1.5, 0]}>
      <torusKnotGeometry args={[0.8, 0.26, 120, 20]} />
      <meshStandardMaterial color={color} metalness={0.3} roughness={0.4} />
    </mesh>
  );
}

/** Small scene for components that show a scene within a scene. */
function Inside({ at = [0, 0, 4] }: { at?: [number, number, number] }) {
  return (
    <>
      <PerspectiveCamera makeDefault position={at} fov={50} />
      <color attach="background" args={['#26182c']} />
      <ambientLight intensity={0.3} />
      {[-1, 0, 1].map((x) => (
        <pointLight key={x} position={[2 * x, 1.5, 1.5]} color={x ? '#60a0ff' : '#ffb060'} intensity={8} />
      ))}
      <mesh rotation={[0.5, 0.7, 0]}>
        <boxGeometry args={[1.4, 1.4, 1.4]} />
        <meshStandardMaterial color="#d0d0c8" />
      </mesh>
    </>
  );
}

/** A box with another scene on its faces. */
function Screen({ farol }: { farol?: FarolProps }) {
  return (
    <Square>
      <mesh position-y={1.7}>
        <boxGeometry args={[2.4, 2.4, 2.4]} />
        <meshStandardMaterial>
          <RenderTexture attach="map" width={128} height={128} samples={0}>
            <Inside />
            {farol && <Farol {...farol} />}
          </RenderTexture>
        </meshStandardMaterial>
      </mesh>
    </Square>
  );
}

function Glow({ farol }: { farol?: FarolProps }) {
  return (
    <Square>
      <Knot />
      <EffectComposer multisampling={0}>
        <>{farol && <FarolInComposer {...farol} />}</>
        <Bloom luminanceThreshold={0.4} intensity={0.8} mipmapBlur />
        <Vignette />
      </EffectComposer>
    </Square>
  );
}

function Portal({ blend }: { blend: number }) {
  return (
    <Square>
      <Knot x={-2.2} />
      <mesh position={[1.2, 1.7, 1]}>
        <planeGeometry args={[3, 3]} />
        <MeshPortalMaterial blend={blend} blur={0} resolution={64}>
          <color attach="background" args={['#26182c']} />
          <Lanterns />
          <Knot color="#70a0c0" />
        </MeshPortalMaterial>
      </mesh>
    </Square>
  );
}

/** Two parts of the canvas, each with a scene and camera of its own, placed by elements of the page. */
function Views({ farol }: { farol?: FarolProps }) {
  const [places] = useState(() => [
    placeOf('top:0; left:0; width:60%; height:100%'),
    placeOf('top:20%; left:65%; width:30%; height:50%'),
  ]);
  useLayoutEffect(() => {
    document.body.append(...places);
    return () => places.forEach((place) => place.remove());
  }, [places]);
  return (
    <>
      <View track={{ current: places[0] }}>
        <Square>
          <PerspectiveCamera makeDefault position={[0, 3.4, 8.5]} rotation-x={-0.2} fov={50} />
          <Knot />
        </Square>
      </View>
      <View index={2} track={{ current: places[1] }}>
        <Inside />
        {farol && <Farol {...farol} />}
      </View>
    </>
  );
}

function placeOf(style: string): HTMLElement {
  const place = document.createElement('div');
  place.style.cssText = `position:fixed; pointer-events:none; ${style}`;
  return place;
}

/** Components that draw outside of the canvas's own draw, by the examples of drei's manual. */
export const parts: Record<string, ComponentType> = {
  View: () => <Views />,
  Hud: () => (
    <Square>
      <Knot />
      <Hud>
        <PerspectiveCamera makeDefault position={[0, 0, 10]} />
        <ambientLight intensity={0.4} />
        <pointLight position={[4, 4, 6]} intensity={60} />
        <mesh position={[3, 2, 0]}>
          <torusGeometry args={[0.8, 0.3, 24, 48]} />
          <meshStandardMaterial color="#60c080" />
        </mesh>
      </Hud>
    </Square>
  ),
  GizmoHelper: () => (
    <Square>
      <Knot />
      <GizmoHelper alignment="bottom-right" margin={[50, 50]}>
        <GizmoViewport labelColor="white" />
      </GizmoHelper>
    </Square>
  ),
  RenderTexture: () => <Screen />,
  MeshPortalMaterial: () => <Portal blend={0} />,
  'MeshPortalMaterial, half way in': () => <Portal blend={0.5} />,
  EffectComposer: () => <Glow />,
  CubeCamera: () => (
    <Square>
      <Knot x={-2.4} />
      <CubeCamera resolution={64} position={[1.2, 1.6, 0]}>
        {(texture) => (
          <mesh>
            <sphereGeometry args={[1.3, 48, 32]} />
            <meshLambertMaterial envMap={texture} color="#d0d0d0" reflectivity={0.8} />
          </mesh>
        )}
      </CubeCamera>
    </Square>
  ),
  // memoized: otherwise each render of the component makes another one
  Environment: memo(() => (
    <Square>
      <Knot />
      <Environment resolution={64}>
        <Lightformer position={[0, 5, -5]} scale={[10, 4, 1]} intensity={2} color="#80b0ff" />
        <Lightformer position={[5, 1, 3]} scale={[3, 3, 1]} intensity={3} target={[0, 0, 0]} />
      </Environment>
    </Square>
  )),
  MeshReflectorMaterial: () => (
    <Square
      floor={<MeshReflectorMaterial color="#9a9488" resolution={128} mirror={0.7} mixStrength={2} roughness={0.8} />}
    >
      <Knot />
    </Square>
  ),
  ContactShadows: () => (
    <Square>
      <Knot />
      <ContactShadows position-y={0.01} resolution={128} scale={8} blur={1.5} far={4} />
    </Square>
  ),
  AccumulativeShadows: () => (
    <Square>
      <mesh castShadow position-y={1}>
        <boxGeometry />
        <meshStandardMaterial color="#c98f5a" />
      </mesh>
      <AccumulativeShadows position-y={0.01} frames={6} resolution={128} scale={10} alphaTest={0.7} opacity={0.9}>
        <directionalLight castShadow position={[4, 6, 3]} intensity={3} />
      </AccumulativeShadows>
      <Preload all />
    </Square>
  ),
};

/** Canvas of which Farol draws one scene and three the rest. */
export const partsWithFarol: Record<string, ComponentType<{ farol: FarolProps }>> = {
  'Farol in a View': Views,
  'Farol in a RenderTexture': Screen,
  'FarolInComposer in an EffectComposer': Glow,
};
