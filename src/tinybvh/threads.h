// The threads of a build: tinybvh's own pools, and the processors that they may run on. A part of shim.cpp, after
// tiny_bvh.h.

#include <chrono>
#ifdef __linux__
#include <sched.h>
#endif

namespace {

// tinybvh's own pools for a build on several threads, one for subtrees and one for bins, which end with it. They have
// as many threads as the machine, whatever was asked for; the processors that they may run on are as many as asked.
class Pools {
	JobSystem *subtrees, *bins;
	std::atomic<bool> done{ false };
	std::thread waker;
public:
	Pools() : subtrees( globalSubtreeJobs = new JobSystem() ), bins( globalBinningJobs = new JobSystem() )
	{
		// A worker that looks for work, finds none, and then goes to sleep, misses what was called between the two.
		waker = std::thread( [this] {
			while (!done.load()) {
				std::this_thread::sleep_for( std::chrono::milliseconds( 1 ) );
				subtrees->res.sleepingCondition.notify_all(), bins->res.sleepingCondition.notify_all();
			}
		} );
	}
	~Pools()
	{
		done.store( true ), waker.join();
		delete subtrees, delete bins;
		globalSubtreeJobs = globalBinningJobs = 0;
	}
};

// This thread, and those that it starts, on so many of its processors, from the one on which it runs, until the end of
// the scope. One thread may run on any.
class Processors {
	bool few = false;
#ifdef __linux__
	cpu_set_t before;
#endif
public:
	bool may_be_several = true;
	explicit Processors( uint32_t threads )
	{
	#ifdef __linux__
		if (threads < 2) return;
		const int here = sched_getcpu();
		if (here < 0 || sched_getaffinity( 0, sizeof before, &before )) { may_be_several = false; return; }
		if (threads >= (uint32_t)CPU_COUNT( &before )) return;
		cpu_set_t own;
		CPU_ZERO( &own );
		for (int i = 0; i < CPU_SETSIZE && threads; i++) {
			const int processor = (here + i) % CPU_SETSIZE;
			if (CPU_ISSET( processor, &before )) CPU_SET( processor, &own ), threads--;
		}
		few = !sched_setaffinity( 0, sizeof own, &own ), may_be_several = few;
	#else
		may_be_several = threads >= std::thread::hardware_concurrency();
	#endif
	}
	~Processors()
	{
	#ifdef __linux__
		if (few) sched_setaffinity( 0, sizeof before, &before );
	#endif
	}
};

} // namespace
