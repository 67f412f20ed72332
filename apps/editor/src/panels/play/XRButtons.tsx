import { t } from '@farol/editing';
import type { XRMode } from '@farol/engine/xr';
import { type ReactNode, useEffect, useRef, useState } from 'react';
import { Button } from '../../ui/Button';
import { useEditor } from '../../ui/EditorContext';

const fetchXR = () => import('@farol/engine/xr');

/** Buttons that show the playing scene in a headset; nothing without one. When playing stops, the XR session ends. */
export function XRButtons(): ReactNode {
  const editor = useEditor();
  const [modes, setModes] = useState<readonly XRMode[]>([]);
  useEffect(() => {
    if ('xr' in navigator) editor.attempt(async () => setModes(await (await fetchXR()).xrModes()));
  }, [editor]);
  const session = useRef<Promise<XRSession>>(null);
  // the promise is rejected when the user has refused the session, or has ended it already
  useEffect(() => () => void session.current?.then((begun) => begun.end()).catch(() => undefined), []);
  const enter = async (mode: XRMode): Promise<void> => {
    const { viewport, document } = editor;
    const { loop, picture, lookThrough, rayCamera } = viewport;
    const { playInXR } = await fetchXR();
    session.current = playInXR(
      {
        picture,
        scene: document.scene,
        camera: lookThrough?.three ?? rayCamera,
        advance: (seconds) => document.simulation.advance(seconds),
        pause: () => loop.stop(),
        resume: () => loop.start(),
      },
      mode,
    );
    await session.current;
  };
  return modes.map((mode) => (
    <Button
      key={mode}
      label={mode === 'immersive-vr' ? t('Enter VR') : t('Enter AR')}
      look="small framed"
      onClick={() => editor.attempt(() => enter(mode))}
    />
  ));
}
