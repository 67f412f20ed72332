import { type ReactNode, useLayoutEffect, useRef } from 'react';
import { useEditor } from '../../ui/EditorContext';
import './viewport.css';
import { ViewportToolbar } from './ViewportToolbar';

/** The picture. The canvas is the Viewport's own: React only gives it a place. */
export function ViewportPanel(): ReactNode {
  const { viewport } = useEditor();
  const place = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    viewport.attach(place.current!);
    return () => viewport.detach();
  }, [viewport]);
  return (
    <section className="panel viewport" aria-label="Viewport">
      <div ref={place} className="viewport-place" />
      <ViewportToolbar />
    </section>
  );
}
