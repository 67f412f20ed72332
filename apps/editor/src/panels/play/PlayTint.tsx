import { useLayoutEffect } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import './playFrame.css';

/** Tints the whole window while the scene plays or is paused. */
export function PlayTint(): null {
  const { simulation } = useEditor().document;
  useSignal(simulation.changed);
  const { state } = simulation;
  useLayoutEffect(() => {
    const { dataset } = document.documentElement;
    if (state === 'stopped') delete dataset.play;
    else dataset.play = state;
    return () => void delete dataset.play;
  }, [state]);
  return null;
}
