import { t } from '@farol/editing';
import { Component, type ReactNode } from 'react';

interface State {
  readonly error: Error | null;
}

/** Error boundary: an error in a panel replaces only that panel. */
export class PanelBoundary extends Component<{ readonly children: ReactNode }, State> {
  override state: State = { error: null };

  static getDerivedStateFromError(error: Error): State {
    return { error };
  }

  override render(): ReactNode {
    const { error } = this.state;
    if (error === null) return this.props.children;
    return (
      <div className="panel-empty" role="alert">
        <p>{t('This panel has stopped: {message}', { message: error.message })}</p>
        <button type="button" className="button" onClick={() => this.setState({ error: null })}>
          {t('Show it again')}
        </button>
      </div>
    );
  }
}
