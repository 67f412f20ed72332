import { type ReactNode, useEffect, useRef, useState } from 'react';
import { HEADER, type TimelineView } from './TimelineView';
import { TimelineCorner } from './TimelineCorner';
import { TimelineSheet } from './TimelineSheet';
import { TrackList } from './TrackList';

/** Names of tracks at the left, keys or curves at the right; they scroll together. */
export function TimelineBody({ view }: { view: TimelineView }): ReactNode {
  const scroller = useRef<HTMLDivElement>(null);
  const [height, setHeight] = useState(0);
  const [scrollTop, setScrollTop] = useState(0);
  useEffect(() => {
    const element = scroller.current!;
    const observer = new ResizeObserver(() => setHeight(element.clientHeight));
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  return (
    <div
      className="timeline-body"
      ref={scroller}
      onScroll={(event) => {
        view.scrollTop = event.currentTarget.scrollTop;
        setScrollTop(view.scrollTop);
        view.draw();
      }}
    >
      <div className="timeline-columns" style={{ minHeight: HEADER + view.rows.length * view.rowHeight }}>
        <div className="timeline-left">
          <TimelineCorner view={view} />
          <TrackList view={view} height={height - HEADER} scrollTop={scrollTop} scroller={scroller} />
        </div>
        <TimelineSheet view={view} height={height} scroller={scroller} />
      </div>
    </div>
  );
}
