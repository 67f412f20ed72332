import { type ReactNode, useLayoutEffect } from 'react';
import { usePreferences } from '../ui/preferences';
import { ResizeHandle } from '../ui/ResizeHandle';
import { DialogHost } from './dialogs/DialogHost';
import { NoticeList } from './dialogs/NoticeList';
import { panels } from './index';
import { StatusBar } from './status/StatusBar';
import { Toolbar } from './toolbar/Toolbar';

const LIMITS = { min: 180, max: 560 };

function place(name: 'left' | 'middle' | 'right'): ReactNode {
  return panels.filter((panel) => panel.place === name).map(({ id, component: Component }) => <Component key={id} />);
}

/** The editor's window: bar, panels, status. */
export function Layout(): ReactNode {
  const { left, right, theme } = usePreferences();
  useLayoutEffect(() => {
    document.documentElement.dataset.theme = theme;
  }, [theme]);
  return (
    <div className="layout" style={{ gridTemplateColumns: `${left}px 0 minmax(0, 1fr) 0 ${right}px` }}>
      <Toolbar />
      <div className="column">{place('left')}</div>
      <ResizeHandle
        {...LIMITS}
        label="Width of the hierarchy"
        width={left}
        side="left"
        onChange={(width) => usePreferences.setState({ left: width })}
      />
      <main className="column">
        {place('middle')}
        <NoticeList />
      </main>
      <ResizeHandle
        {...LIMITS}
        label="Width of the inspector"
        width={right}
        side="right"
        onChange={(width) => usePreferences.setState({ right: width })}
      />
      <div className="column">{place('right')}</div>
      <StatusBar />
      <DialogHost />
    </div>
  );
}
