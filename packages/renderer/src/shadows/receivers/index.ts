export { VisibleReceivers } from './VisibleReceivers';
