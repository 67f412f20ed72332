export { SeenReceivers } from './SeenReceivers';
