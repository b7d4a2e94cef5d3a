/* The model of a GPU: streams that put off what they are asked, events, graphs. */
#include "model.h"

#include <deque>
#include <vector>

struct model_stream {
    std::deque<std::function<void()>> queue;
    model_graph *capture; /* or NULL */
};
struct model_event {
    model_stream *by;
    long asked, done;
};
struct model_graph {
    std::vector<std::function<void()>> nodes;
    int owners; /* of the graph and of its executable */
};

static std::vector<model_stream *> streams;

std::recursive_mutex model_mutex;

cudaError_t model_queue(cudaStream_t stream, std::function<void()> what)
{
    MODEL_LOCK;
    if (stream->capture)
        stream->capture->nodes.push_back(what);
    else
        stream->queue.push_back(what);
    return model_state();
}

static void stream_step(model_stream *s)
{
    std::function<void()> what = s->queue.front();
    s->queue.pop_front();
    if (!model_lost)
        what();
}

cudaError_t cudaStreamSynchronize(cudaStream_t s)
{
    MODEL_LOCK;
    if (s->capture)
        return model_failed(cudaErrorStreamCaptureUnsupported);
    while (!s->queue.empty())
        stream_step(s);
    return model_state();
}

void model_synchronize()
{
    for (model_stream *s : streams)
        while (!s->queue.empty())
            stream_step(s);
}

cudaError_t cudaStreamCreateWithFlags(cudaStream_t *s, unsigned)
{
    MODEL_LOCK;
    *s = new model_stream();
    streams.push_back(*s);
    return cudaSuccess;
}

cudaError_t cudaStreamDestroy(cudaStream_t s)
{
    MODEL_LOCK;
    cudaStreamSynchronize(s);
    for (size_t k = 0; k < streams.size(); k++)
        if (streams[k] == s)
            streams.erase(streams.begin() + (long)k--);
    delete s;
    return cudaSuccess;
}

cudaError_t cudaEventCreateWithFlags(cudaEvent_t *event, unsigned)
{
    *event = new model_event();
    return cudaSuccess;
}

cudaError_t cudaEventCreate(cudaEvent_t *event)
{
    return cudaEventCreateWithFlags(event, 0);
}

cudaError_t cudaEventDestroy(cudaEvent_t event)
{
    MODEL_LOCK;
    model_synchronize();
    delete event;
    return cudaSuccess;
}

cudaError_t cudaEventRecord(cudaEvent_t event, cudaStream_t stream)
{
    MODEL_LOCK;
    const long asked = ++event->asked;
    event->by = stream;
    return model_queue(stream, [=] { event->done = asked; });
}

static void event_reach(model_event *event, long asked)
{
    while (event->done < asked && !model_lost)
        stream_step(event->by);
}

cudaError_t cudaStreamWaitEvent(cudaStream_t stream, cudaEvent_t event, unsigned)
{
    MODEL_LOCK;
    const long asked = event->asked;
    return model_queue(stream, [=] { event_reach(event, asked); });
}

cudaError_t cudaEventSynchronize(cudaEvent_t event)
{
    MODEL_LOCK;
    event_reach(event, event->asked);
    return model_state();
}

cudaError_t cudaEventElapsedTime(float *ms, cudaEvent_t, cudaEvent_t)
{
    *ms = 1;
    return cudaSuccess;
}

cudaError_t cudaStreamBeginCapture(cudaStream_t s, cudaStreamCaptureMode)
{
    MODEL_LOCK;
    if (s->capture)
        return model_failed(cudaErrorStreamCaptureUnsupported);
    if (model_lost)
        return model_state();
    s->capture = new model_graph();
    s->capture->owners = 1;
    return cudaSuccess;
}

cudaError_t cudaStreamEndCapture(cudaStream_t s, cudaGraph_t *graph)
{
    MODEL_LOCK;
    *graph = s->capture;
    s->capture = NULL;
    return *graph ? cudaSuccess : model_failed(cudaErrorInvalidValue);
}

cudaError_t cudaStreamIsCapturing(cudaStream_t s, cudaStreamCaptureStatus *status)
{
    *status = s->capture ? cudaStreamCaptureStatusActive : cudaStreamCaptureStatusNone;
    return cudaSuccess;
}

cudaError_t cudaGraphInstantiate(cudaGraphExec_t *exec, cudaGraph_t graph, unsigned long long)
{
    graph->owners++;
    *exec = graph;
    return cudaSuccess;
}

cudaError_t cudaGraphDestroy(cudaGraph_t graph)
{
    MODEL_LOCK;
    if (--graph->owners == 0)
        delete graph;
    return cudaSuccess;
}

cudaError_t cudaGraphExecDestroy(cudaGraphExec_t exec)
{
    return cudaGraphDestroy(exec);
}

static void graph_run(const model_graph *graph)
{
    model_in_graph = true;
    for (const std::function<void()> &node : graph->nodes)
        if (!model_lost)
            node();
    model_in_graph = false;
}

cudaError_t cudaGraphLaunch(cudaGraphExec_t exec, cudaStream_t stream)
{
    return model_queue(stream, [=] { graph_run(exec); });
}
