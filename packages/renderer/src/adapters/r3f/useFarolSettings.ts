import { useThree } from '@react-three/fiber';
import { type Ref, useEffect, useImperativeHandle, useLayoutEffect, useRef, useState } from 'react';
import type { Object3D } from 'three';
import { defaultOptions, type FarolOptions } from '../../renderer/FarolOptions';
import type { FarolRenderer } from '../../renderer/FarolRenderer';
import { CanvasFarol, type FarolSettings } from './CanvasFarol';
import { useFarol } from './useFarol';

/** Props of `<Farol>` and `<FarolInComposer>`; all may change at any time. */
export interface FarolProps extends FarolOptions {
  /** Effects: must be the same list from render to render (`useMemo`); disposed with the component. Default none. */
  effects?: FarolOptions['effects'];
  /** Whether Farol draws; if false, its resources are freed, and three draws. Default true. */
  enabled?: boolean;
  /** Receives the FarolRenderer, for `info`, `microshaders` and the like; null while not enabled. */
  ref?: Ref<FarolRenderer | null>;
}

const optionNames = Object.keys(defaultOptions) as (keyof FarolOptions)[];

const isSame = (a: FarolSettings, b: FarolSettings): boolean =>
  optionNames.every((name) => a.options[name] === b.options[name] || name === 'budget') &&
  JSON.stringify(a.options.budget) === JSON.stringify(b.options.budget) &&
  a.scene === b.scene &&
  a.invalidate === b.invalidate;

/**
 * Lets Farol draw a scene of the canvas while the component is mounted.
 * @param scene - scene; null for all that the canvas draws
 */
export function useFarolSettings(props: FarolProps, scene: Object3D | null): void {
  const { enabled = true, ref, ...options } = props;
  const webgl = useThree((state) => state.gl);
  const invalidate = useThree((state) => state.invalidate);
  const canvas = CanvasFarol.of(webgl);
  const [owner] = useState(() => ({}));
  const asked: FarolSettings = { options, scene, invalidate };
  const [settings, setSettings] = useState(asked);
  // makes React render again, before it runs the effects (React's) below
  if (!isSame(asked, settings)) setSettings(asked);
  const follow = useRef(() => {});

  // mounts before the next frame; unmounted by the effect below, since React ends layout effects while a sibling suspends
  useLayoutEffect(() => {
    follow.current = () => (enabled ? canvas.mount(owner, settings) : canvas.unmount(owner));
    follow.current();
  }, [canvas, owner, enabled, settings]);
  useEffect(() => {
    follow.current(); // again, since React may have run the cleanup below without the layout effect
    return () => canvas.unmount(owner);
  }, [canvas, owner]);

  const farol = useFarol();
  useImperativeHandle<FarolRenderer | null, FarolRenderer | null>(ref, () => (enabled ? farol : null), [
    farol,
    enabled,
  ]);
}
