import { type ReactNode, useLayoutEffect, useRef } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import './viewport.css';
import { PreviewFrame } from './PreviewFrame';
import { StatisticsOverlay } from './StatisticsOverlay';
import { ViewCube } from './ViewCube';
import { ViewportToolbar } from './ViewportToolbar';

/** The picture. The canvas is the Viewport's own: React only gives it a place. */
export function ViewportPanel(): ReactNode {
  const { viewport } = useEditor();
  useSignal(viewport.changed);
  const place = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    viewport.attach(place.current!);
    return () => viewport.detach();
  }, [viewport]);
  return (
    <section className="panel viewport" aria-label="Viewport">
      <div ref={place} className="viewport-place" />
      <ViewportToolbar />
      {viewport.lookThrough === null && <ViewCube />}
      {viewport.showStatistics && <StatisticsOverlay />}
      <PreviewFrame />
    </section>
  );
}
