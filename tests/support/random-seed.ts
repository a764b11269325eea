/**
 * The seed of random cases: always the same for a commit, so that a failure is one of the change;
 * another one in each thorough run.
 */
import fc from 'fast-check';

import {isThorough} from './level.js';

fc.configureGlobal({seed: isThorough ? Date.now() % 2 ** 31 : 1});
