import { t } from '@farol/editing';
import type { SceneSettings } from '@farol/engine';
import type { ReactNode } from 'react';
import { SettingsSection } from './PictureSections';

const names = ['gravity'];

export const PhysicsSection = ({ settings }: { settings: SceneSettings }): ReactNode => (
  <SettingsSection
    id="Physics"
    title={t('Physics')}
    help={t('How bodies move while the scene plays.')}
    icon="body"
    settings={settings}
    names={names}
  />
);
