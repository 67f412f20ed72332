import { LabStage } from './LabStage';

// interface for the page that contains this iframe: see Stage.ts
window.stage = new LabStage();
